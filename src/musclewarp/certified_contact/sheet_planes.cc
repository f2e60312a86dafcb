// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/sheet_planes.h"

#include <algorithm>

#include "musclewarp/certified_contact/triangle_separation.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::RowVector3i;

// True if the triangles turn their front sides, or their back sides, to each
// other across the plane with this normal.
bool FaceEachOther(const Corners& f, const Corners& g, const RowVector3d& normal) {
  const RowVector3d area_f = AreaVector(f), area_g = AreaVector(g);
  const double share = 0.5;
  const double up = area_f.dot(normal) / area_f.norm();
  const double down = -area_g.dot(normal) / area_g.norm();
  return std::min(up, down) > share || std::max(up, down) < -share;
}

bool ShareAnEdge(const RowVector3i& a, const RowVector3i& b) {
  int shared = 0;
  for (const int corner : a) shared += (b.array() == corner).any() ? 1 : 0;
  return shared >= 2;
}

}  // namespace

std::optional<SeparatingPlane> PlaneBetweenSheets(const StepOptions& options,
                                                  const ContactStep& step,
                                                  const Points& targets,
                                                  int muscle,
                                                  int f,
                                                  int g) {
  const RowVector3i a = step.scene.muscles[muscle].triangles.row(f);
  const RowVector3i b = step.scene.muscles[muscle].triangles.row(g);
  auto separation = SeparateSheets(step.before.points[muscle], a, b);
  const bool were_apart = separation.has_value();
  if (!were_apart) separation = SeparateSheets(targets, a, b);
  if (!separation) return std::nullopt;
  const double half_gap =
      std::min(options.gap,
               options.defects.sheet_share * separation->distance) /
      2;
  SeparatingPlane plane =
      PlaneBetween(step, muscle, f, muscle, g, *separation, half_gap);
  if (!were_apart) plane.normal = separation->normal;
  for (const int corner : a) {
    if ((b.array() == corner).any()) plane.shared_corner = corner;
  }
  if (plane.shared_corner < 0) return plane;
  // The shared corner is on the plane; another one stands in for it.
  for (RowVector3i* corners : {&plane.above, &plane.below}) {
    const int other = (*corners)[0] == plane.shared_corner ? 1 : 0;
    for (int k = 0; k < 3; ++k) {
      if ((*corners)[k] == plane.shared_corner)
        (*corners)[k] = (*corners)[other];
    }
  }
  return plane;
}


std::vector<SeparatingPlane> FindPlanesBetweenSheets(const StepOptions& options,
                                                     const ContactStep& step,
                                                     int muscle) {
  const double radius = options.gap + options.planes.search_share * options.reach;
  const TriangleBvh& tree = step.trees_before[muscle];
  const Triangles& triangles = step.scene.muscles[muscle].triangles;
  const Points& before = step.before.points[muscle];
  std::vector<std::vector<SeparatingPlane>> found(tree.num_triangles());
#pragma omp parallel for schedule(dynamic, 64)
  for (int f = 0; f < tree.num_triangles(); ++f) {
    const Box3 box = BoxOf(tree.corners(f), radius);
    tree.Traverse(
        [&](const Box3& node) { return node.Overlaps(box); },
        [&](int g) {
          if (g <= f) return;
          if (ShareAnEdge(triangles.row(f), triangles.row(g))) return;
          if (AreaVector(tree.corners(f)).dot(AreaVector(tree.corners(g))) > 0) return;
          const auto separation = SeparateSheets(before, triangles.row(f), triangles.row(g));
          if (!separation || separation->distance > radius) return;
          if (!FaceEachOther(tree.corners(f), tree.corners(g), separation->normal)) return;
          const auto plane = PlaneBetweenSheets(options, step, before, muscle, f, g);
          if (plane) found[f].push_back(*plane);
        });
  }
  std::vector<SeparatingPlane> planes;
  for (const auto& part : found) planes.insert(planes.end(), part.begin(), part.end());
  return planes;
}

}  // namespace musclewarp
