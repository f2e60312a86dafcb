// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/bone_sides.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/point_search.h"

namespace musclewarp {
namespace {

constexpr char kMirrored[] =
    "a mirrored image is the usual cause; correct the side, or mirror the "
    "bones";

Eigen::Vector3d MiddleOf(const SampledBone& bone) {
  return bone.surface.points.colwise().mean().transpose();
}

// The middle between the bones of a kind, if there are any.
std::optional<Eigen::Vector3d> MiddleBetween(
    const std::vector<SampledBone>& bones, BoneKind kind, int* count) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  *count = 0;
  for (const SampledBone& bone : bones) {
    if (bone.bone.kind != kind || bone.surface.size() == 0) continue;
    sum += MiddleOf(bone);
    ++*count;
  }
  if (*count == 0) return std::nullopt;
  return sum / *count;
}

// The middle of the sacrum or the pelvis, of which both halves may be meshes of
// their own, or between both hip bones.
std::optional<Eigen::Vector3d> MiddleOfBody(
    const std::vector<SampledBone>& bones) {
  int count = 0;
  for (const BoneKind kind : {BoneKind::kSacrum, BoneKind::kPelvis}) {
    const auto middle = MiddleBetween(bones, kind, &count);
    if (middle) return middle;
  }
  const auto middle = MiddleBetween(bones, BoneKind::kHipBone, &count);
  return count == 2 ? middle : std::nullopt;
}

std::optional<Side> SideByPlace(
    const Eigen::Vector3d& place,
    const std::optional<Eigen::Matrix3d>& image_axes,
    const std::optional<Eigen::Vector3d>& middle) {
  if (!image_axes || !middle) return std::nullopt;
  const double right = (place - *middle).dot(image_axes->col(2));
  if (std::abs(right) < kJointSearch.body.off_middle) return std::nullopt;
  return right > 0 ? Side::kRight : Side::kLeft;
}

void CheckFemur(const SampledBone& bone,
                const std::optional<Eigen::Matrix3d>& image_axes,
                const std::optional<Eigen::Vector3d>& middle) {
  const std::optional<Side> by_shape = bone.femur.ShapeSide();
  if (!by_shape) return;
  if (bone.bone.side && *bone.bone.side != *by_shape) {
    throw InputError(bone.bone.name,
                     "has the shape of a " + ToString(*by_shape) +
                         " femur and is named " + ToString(*bone.bone.side),
                     kMirrored);
  }
  const std::optional<Side> by_place =
      SideByPlace(bone.femur.head->sphere.center, image_axes, middle);
  if (by_place && *by_place != *by_shape) {
    throw InputError(bone.bone.name,
                     "has the shape of a " + ToString(*by_shape) +
                         " femur and lies on the " + ToString(*by_place) +
                         " of the pelvis in the image",
                     kMirrored);
  }
}

// Returns the least distance of a bone from others, at most `most` (mm), by
// some 300 of its points, which are enough to tell legs apart.
double DistanceFrom(const PointSearch& others,
                    const Points& points_of_others,
                    const SampledBone& bone,
                    double most) {
  const int step = std::max(1, bone.surface.size() / 300);
  for (int i = 0; i < bone.surface.size(); i += step) {
    const Eigen::RowVector3d point = bone.surface.points.row(i);
    const int nearest = others.Nearest(point.transpose());
    most = std::min(most, (points_of_others.row(nearest) - point).norm());
  }
  return most;
}

// Gives each bone without a side that of the nearest bone with one, the nearest
// of all first, so that sides spread along a limb.
void SpreadSides(std::vector<SampledBone>* bones,
                 std::vector<std::string>* names) {
  std::vector<double> distance(bones->size(), kJointSearch.body.nearby);
  std::vector<std::optional<Side>> side(bones->size());
  const auto is_waiting = [&](const SampledBone& bone) {
    return HasSide(bone.bone.kind) && !bone.bone.side &&
           bone.surface.size() > 0;
  };
  const auto spread_from = [&](const SampledBone& from) {
    const PointSearch search(from.surface.points);
    for (size_t i = 0; i < bones->size(); ++i) {
      if (!is_waiting((*bones)[i])) continue;
      const double between =
          DistanceFrom(search, from.surface.points, (*bones)[i], distance[i]);
      if (between >= distance[i]) continue;
      distance[i] = between;
      side[i] = from.bone.side;
    }
  };
  for (const SampledBone& bone : *bones) {
    if (bone.bone.side && bone.surface.size() > 0) spread_from(bone);
  }
  while (true) {
    int next = -1;
    for (size_t i = 0; i < bones->size(); ++i) {
      if (!is_waiting((*bones)[i]) || !side[i]) continue;
      if (next < 0 || distance[i] < distance[next]) next = static_cast<int>(i);
    }
    if (next < 0) return;
    SampledBone& bone = (*bones)[next];
    bone.bone.side = side[next];
    names->push_back(bone.bone.name + " (" + ToString(*side[next]) + ")");
    spread_from(bone);
  }
}

}  // namespace

bool HasSide(BoneKind kind) {
  return kind != BoneKind::kOther && kind != BoneKind::kPelvis &&
         kind != BoneKind::kSacrum;
}

bool AgreeWithImage(const std::vector<SampledBone>& bones,
                    const Eigen::Matrix3d& image_axes) {
  const double least = std::sqrt(0.5);  // 45 degrees
  for (const SampledBone& bone : bones) {
    if (!bone.femur.ShapeSide()) continue;
    const BoneDirections& directions = *bone.femur.directions;
    if (directions.up.dot(image_axes.col(1)) < least) return false;
    if (directions.back.dot(-image_axes.col(0)) < least) return false;
  }
  return true;
}

bool DecideSides(const std::optional<Side>& otherwise,
                 const std::optional<Eigen::Matrix3d>& image_axes,
                 std::vector<SampledBone>* bones,
                 std::vector<std::string>* notes) {
  const std::optional<Eigen::Vector3d> middle = MiddleOfBody(*bones);
  for (SampledBone& bone : *bones) {
    if (bone.bone.kind != BoneKind::kFemur) continue;
    CheckFemur(bone, image_axes, middle);
    if (bone.bone.side) continue;
    bone.bone.side = bone.femur.ShapeSide();
    if (bone.bone.side) {
      notes->push_back(bone.bone.name + ": a " + ToString(*bone.bone.side) +
                       " femur, by its shape");
    }
  }
  for (SampledBone& bone : *bones) {
    if (HasSide(bone.bone.kind) && !bone.bone.side) bone.bone.side = otherwise;
  }
  bool all_have_sides = true;
  std::vector<std::string> spread;
  SpreadSides(bones, &spread);
  if (!spread.empty()) {
    notes->push_back("sides by the nearest bone that has one: " +
                     ShortList(spread));
  }
  for (SampledBone& bone : *bones) {
    if (!HasSide(bone.bone.kind) || bone.bone.side) continue;
    if (bone.surface.size() > 0) {
      bone.bone.side = SideByPlace(MiddleOf(bone), image_axes, middle);
    }
    if (bone.bone.side) {
      notes->push_back(bone.bone.name + ": " + ToString(*bone.bone.side) +
                       ", by its place in the image");
    } else {
      notes->push_back(bone.bone.name +
                       ": of no joint, as nothing tells its side; {side} or a "
                       "column \"side\" does");
      bone.bone.kind = BoneKind::kOther;
      all_have_sides = false;
    }
  }
  return all_have_sides;
}

}  // namespace musclewarp
