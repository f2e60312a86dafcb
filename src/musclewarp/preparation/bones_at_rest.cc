// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bones_at_rest.h"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <sstream>

#include "musclewarp/base/text.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

// Bones closer to each other at rest than this, mm, may form a joint.
constexpr double kJointGap = 30;

// Bones of a joint slide on each other by at most kLongSlide between frames,
// mm, or by up to kLongestSlide if the gap between them grows by less than
// kWideGap.
constexpr double kLongSlide = 50;
constexpr double kWideGap = 20;
constexpr double kLongestSlide = 120;

// The approximate number of vertices that are sampled per bone.
constexpr Eigen::Index kVertices = 1000;

struct SearchableBone {
  const BoneAtRest& bone;
  Points vertices;  // a sample
  const TriangleBvh& tree;
};

Points SampleOf(const Points& points) {
  const Eigen::Index step =
      std::max<Eigen::Index>(1, points.rows() / kVertices);
  Points some((points.rows() + step - 1) / step, 3);
  for (Eigen::Index i = 0; i < some.rows(); ++i) {
    some.row(i) = points.row(i * step);
  }
  return some;
}

struct NearestPair {
  double distance = 0;  // mm
  Eigen::RowVector3d middle;
};

// Returns the closest pair of a vertex and a bone, or only the distance `limit`
// if no vertex is closer.
NearestPair NearestTo(const TriangleBvh& tree,
                      const Points& vertices,
                      double limit) {
  NearestPair nearest;
  nearest.distance = limit;
  for (const Eigen::RowVector3d p : vertices.rowwise()) {
    const auto closest = tree.ClosestPoint(p, nearest.distance);
    if (!(closest.distance < nearest.distance)) continue;
    nearest.distance = closest.distance;
    nearest.middle = (p + closest.point) / 2;
  }
  return nearest;
}

// The largest motion of a bone relative to another.
struct BoneMove {
  double distance = 0;  // mm
  int pose = -1;
};

// Returns the largest motion of `b` relative to `a` that exceeds any joint's.
std::optional<BoneMove> ImpossibleMove(const Scene& scene,
                                       const SearchableBone& a,
                                       const SearchableBone& b) {
  const NearestPair rest = NearestTo(a.tree, b.vertices, kJointGap);
  if (rest.distance >= kJointGap) return std::nullopt;
  BoneMove largest;
  const auto relative_motion = [&](int i) -> Eigen::Matrix4d {
    if (i < 0) return Eigen::Matrix4d::Identity();
    const ScenePose& pose = scene.poses[i];
    return BodyTransform(pose, a.bone.body).inverse() *
           BodyTransform(pose, b.bone.body);
  };
  const Points joint = rest.middle;
  const auto count = static_cast<int>(scene.poses.size());
  for (int i = 0; i < count; ++i) {
    const Eigen::Matrix4d now = relative_motion(i);
    const Eigen::Matrix4d before = relative_motion(PoseBefore(scene, i));
    const double moved =
        (Transformed(joint, now) - Transformed(joint, before)).norm();
    if (moved <= std::max(kLongSlide, largest.distance)) continue;
    const double wide = rest.distance + kWideGap;
    const double gap =
        NearestTo(a.tree, Transformed(b.vertices, now), wide).distance;
    if (moved < kLongestSlide && gap < wide) continue;
    largest = {moved, i};
  }
  if (largest.pose < 0) return std::nullopt;
  return largest;
}

std::string MoveText(const Scene& scene,
                     const SearchableBone& a,
                     const SearchableBone& b,
                     const BoneMove& move) {
  std::ostringstream text;
  text << b.bone.name << " moves by "
       << LengthText(move.distance, scene.body_size) << " against "
       << a.bone.name;
  if (const int before = PoseBefore(scene, move.pose); before >= 0) {
    text << " between frames " << before << " and " << move.pose;
  } else {
    text << " between the rest pose and frame " << move.pose;
  }
  text << " (" << scene.poses[move.pose].name
       << "): is the centre of the joint right?";
  return text.str();
}

}  // namespace

std::vector<BoneCrossing> BoneCrossings(const std::vector<BoneAtRest>& bones) {
  std::vector<BoneCrossing> crossings;
  for (size_t a = 0; a < bones.size(); ++a) {
    for (size_t b = a + 1; b < bones.size(); ++b) {
      const TriangleBvh& tree = bones[a].mesh.bvh();
      const auto pairs = IntersectingTriangles(tree, bones[b].mesh.bvh());
      if (pairs.empty()) continue;
      BoneCrossing crossing;
      crossing.a = bones[a].name;
      crossing.b = bones[b].name;
      crossing.triangle_pairs = static_cast<int>(pairs.size());
      for (const auto& [f, g] : pairs) {
        crossing.place += tree.corners(f).colwise().mean();
      }
      crossing.place /= static_cast<double>(pairs.size());
      crossings.push_back(crossing);
    }
  }
  return crossings;
}

std::vector<std::string> BoneMoveWarnings(
    const Scene& scene, const std::vector<BoneAtRest>& bones) {
  std::deque<SearchableBone> searchable;
  for (const BoneAtRest& bone : bones) {
    searchable.push_back({bone, SampleOf(bone.mesh.points()), bone.mesh.bvh()});
  }
  std::vector<std::string> warnings;
  for (size_t a = 0; a < bones.size(); ++a) {
    for (size_t b = a + 1; b < bones.size(); ++b) {
      if (bones[a].body == bones[b].body) continue;
      const auto move = ImpossibleMove(scene, searchable[a], searchable[b]);
      if (!move) continue;
      warnings.push_back(MoveText(scene, searchable[a], searchable[b], *move));
    }
  }
  return warnings;
}

}  // namespace musclewarp
