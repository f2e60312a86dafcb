// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/landmark_point.h"

#include <algorithm>

#include "musclewarp/anatomy/bone_axes.h"
#include "musclewarp/anatomy/bone_match.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The landmark is the mean of what lies at most this share of the extent of the
// region short of its farthest point.
constexpr double kCap = 0.15;
// A region of a coarse mesh without vertices is widened by this share of the
// length of the bone until it has some.
constexpr double kWidening = 0.02;

// Returns the centres of the triangles whose centre lies in a part of an axis.
Points CentresWithin(const TriangleSoup& mesh,
                     const Points& axis,
                     double begin,
                     double end) {
  const RowVector3d along = axis.row(1) - axis.row(0);
  std::vector<RowVector3d> centres;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const RowVector3d centre = (mesh.points.row(mesh.triangles(f, 0)) +
                                mesh.points.row(mesh.triangles(f, 1)) +
                                mesh.points.row(mesh.triangles(f, 2))) /
                               3;
    const double share =
        (centre - axis.row(0)).dot(along) / along.squaredNorm();
    if (share >= begin && share <= end) centres.push_back(centre);
  }
  Points points(static_cast<Eigen::Index>(centres.size()), 3);
  for (size_t i = 0; i < centres.size(); ++i) points.row(i) = centres[i];
  return points;
}

// Returns the point of a mesh at a place, given the directions at the bone.
RowVector3d PointAt(const BonePlace& place,
                    const MeasuredBone& bone,
                    const Eigen::Matrix3d& directions) {
  Points axis = bone.ends;
  const RowVector3d down = (directions * LongAxisOf(place.bone)).transpose();
  if ((axis.row(1) - axis.row(0)).dot(down) < 0) {
    axis.row(0).swap(axis.row(1));
  }
  Points region;
  for (double wider = 0; region.rows() == 0; wider += kWidening) {
    region = CentresWithin(
        bone.bone.mesh, axis, place.begin - wider, place.end + wider);
  }
  const Eigen::VectorXd reach = region * (directions * place.direction);
  const double least =
      reach.maxCoeff() - kCap * (reach.maxCoeff() - reach.minCoeff());
  RowVector3d sum = RowVector3d::Zero();
  int count = 0;
  for (Eigen::Index i = 0; i < region.rows(); ++i) {
    if (reach[i] < least) continue;
    sum += region.row(i);
    ++count;
  }
  const RowVector3d mean = sum / count;
  Eigen::Index nearest = 0;
  (region.rowwise() - mean).rowwise().squaredNorm().minCoeff(&nearest);
  return region.row(nearest);
}

}  // namespace

std::string ToString(LandmarkEvidence evidence) {
  switch (evidence) {
    case LandmarkEvidence::kFound:
      return "found";
    case LandmarkEvidence::kWeak:
      return "weak";
    case LandmarkEvidence::kGuessed:
      return "guessed";
  }
  return "";
}

std::optional<PlaceOnBone> FindPlace(const std::vector<BonePlace>& places,
                                     const std::vector<MeasuredBone>& bones,
                                     const std::optional<Side>& side) {
  for (size_t p = 0; p < places.size(); ++p) {
    for (size_t b = 0; b < bones.size(); ++b) {
      const Bone& bone = bones[b].bone;
      if (side && bone.side && *side != *bone.side) continue;
      if (bones[b].ends.rows() > 0 && NamesBone(bone.name, places[p].bone)) {
        return PlaceOnBone{p, b};
      }
    }
  }
  return std::nullopt;
}

std::optional<LandmarkPoint> FindLandmark(
    const std::vector<BonePlace>& places,
    const std::vector<MeasuredBone>& bones,
    const std::optional<Side>& side,
    const Eigen::Matrix3d& image) {
  const auto on_bone = FindPlace(places, bones, side);
  if (!on_bone) return std::nullopt;
  const BonePlace& place = places[on_bone->place];
  const MeasuredBone& bone = bones[on_bone->bone];
  const BoneAxes axes =
      AxesAt(on_bone->bone, bones, side ? side : bone.bone.side, image);
  LandmarkPoint found;
  found.bone = on_bone->bone;
  found.point = PointAt(place, bone, axes.directions);
  found.outward = (axes.directions * place.direction).transpose();
  if (!axes.are_from_bones) {
    found.evidence = LandmarkEvidence::kGuessed;
  } else if (place.bone != places.front().bone) {
    found.evidence = LandmarkEvidence::kWeak;  // it stands in
  }
  return found;
}

}  // namespace musclewarp
