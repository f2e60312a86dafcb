// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/tunnelling.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

Box3 BoxOfSegment(const RowVector3d& a, const RowVector3d& b) {
  Corners corners;
  corners << a, b, b;
  return BoxOf(corners);
}

// Returns the fraction of the path from `start` to `end` before it hits a
// triangle, 1 if it does not (Moeller and Trumbore 1997). Rounding at edges
// does not matter, as the paths of neighbouring vertices hit the mesh, too.
double ShareBefore(const RowVector3d& start,
                   const RowVector3d& end,
                   const Corners& triangle) {
  const RowVector3d way = end - start;
  const RowVector3d u = triangle.row(1) - triangle.row(0);
  const RowVector3d v = triangle.row(2) - triangle.row(0);
  const RowVector3d across = way.cross(v);
  const double determinant = u.dot(across);
  if (determinant == 0) return 1;
  const RowVector3d from = start - triangle.row(0);
  const double at_u = from.dot(across) / determinant;
  const RowVector3d normal = from.cross(u);
  const double at_v = way.dot(normal) / determinant;
  const double share = v.dot(normal) / determinant;
  const bool meets = at_u >= 0 && at_v >= 0 && at_u + at_v <= 1 && share >= 0;
  return meets ? std::min(share, 1.0) : 1;
}

// Returns for each vertex true if one of its triangles may cross the bone.
std::vector<char> ExemptVertices(const MuscleSurface& muscle, int bone) {
  std::vector<char> exempt(muscle.num_vertices(), 0);
  for (Eigen::Index f = 0; f < muscle.triangles.rows(); ++f) {
    if (!muscle.IsExempt(bone, f)) continue;
    for (const int v : muscle.triangles.row(f)) exempt[v] = 1;
  }
  return exempt;
}

// Returns true if no path of the muscle, whose vertices are predicted in a box,
// meets the box of the bone.
bool IsBesideBone(const ContactStep& step,
                  const Box3& predicted,
                  int bone,
                  int muscle) {
  const Box3 starts =
      Transformed(step.trees_before[muscle].box(),
                  RigidInverse(step.before.bones_from_rest[bone]));
  const Box3 ends =
      Transformed(predicted, RigidInverse(step.bones_from_rest[bone]));
  return !BoxOf(starts, ends).Overlaps(step.scene.bones[bone]->box());
}

double PassageThrough(const ContactStep& step, int bone, int muscle) {
  const Points starts =
      Transformed(step.before.points[muscle],
                  RigidInverse(step.before.bones_from_rest[bone]));
  const Points ends = Transformed(step.predicted[muscle],
                                  RigidInverse(step.bones_from_rest[bone]));
  const TriangleBvh& tree = *step.scene.bones[bone];
  const std::vector<char> exempt =
      ExemptVertices(step.scene.muscles[muscle], bone);
  double longest = 0;
#pragma omp parallel for schedule(dynamic, 256) reduction(max : longest)
  for (Eigen::Index v = 0; v < starts.rows(); ++v) {
    const RowVector3d start = starts.row(v), end = ends.row(v);
    const double length = (end - start).norm();
    if (exempt[v] || length <= longest) continue;
    const Box3 box = BoxOfSegment(start, end);
    double share = 1;
    tree.Traverse([&](const Box3& node) { return node.Overlaps(box); },
                  [&](int f) {
                    share = std::min(share,
                                     ShareBefore(start, end, tree.corners(f)));
                  });
    longest = std::max(longest, (1 - share) * length);
  }
  return longest;
}

}  // namespace

double MaxTunnelling(const ContactStep& step) {
  double longest = 0;
  std::vector<Box3> predicted;
  for (const Points& points : step.predicted) {
    predicted.push_back(BoxOf(points));
  }
  for (int bone = 0; bone < step.num_bones(); ++bone) {
    if (step.scene.bones[bone]->num_triangles() == 0) continue;
    for (int muscle = 0; muscle < step.num_muscles(); ++muscle) {
      if (IsBesideBone(step, predicted[muscle], bone, muscle)) continue;
      longest = std::max(longest, PassageThrough(step, bone, muscle));
    }
  }
  return longest;
}

}  // namespace musclewarp
