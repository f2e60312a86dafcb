// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/sheet_planes.h"

#include <algorithm>
#include <cstdint>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/work_counts.h"
#include "musclewarp/proximity/triangle_separation.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::RowVector3i;

// Returns true if the triangles face each other with their front sides, or with
// their back sides, across the plane with this normal.
bool FaceEachOther(const RowVector3d& unit_f,
                   const RowVector3d& unit_g,
                   const RowVector3d& normal,
                   double min_facing) {
  const double up = unit_f.dot(normal), down = -unit_g.dot(normal);
  return std::min(up, down) > min_facing || std::max(up, down) < -min_facing;
}

bool ShareAnEdge(const RowVector3i& a, const RowVector3i& b) {
  int shared = 0;
  for (const int corner : a) shared += (b.array() == corner).any() ? 1 : 0;
  return shared >= 2;
}

Points UnitNormals(const TriangleBvh& tree) {
  Points normals(tree.num_triangles(), 3);
  for (int f = 0; f < tree.num_triangles(); ++f) {
    const RowVector3d area = AreaVector(tree.corners(f));
    normals.row(f) = area.norm() > 0 ? area.normalized() : area;
  }
  return normals;
}

// Returns a box around the normals of the triangles of each node of the tree.
std::vector<Box3> NormalsOfNodes(const TriangleBvh& tree,
                                 const Points& normals) {
  std::vector<Box3> boxes(normals.rows());
  for (Eigen::Index f = 0; f < normals.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      boxes[f].lower[k] = boxes[f].upper[k] = normals(f, k);
    }
  }
  return tree.BoxesOfNodes(boxes);
}

// Returns the smallest dot product of vectors in two boxes.
double LeastProduct(const Box3& a, const Box3& b) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    sum += std::min({a.lower[k] * b.lower[k],
                     a.lower[k] * b.upper[k],
                     a.upper[k] * b.lower[k],
                     a.upper[k] * b.upper[k]});
  }
  return sum;
}

// Returns true if two boxes are at most `distance` apart along each axis.
bool AreWithin(const Box3& a, const Box3& b, double distance) {
  bool are_within = true;
  for (int k = 0; k < 3; ++k) {
    are_within &= a.lower[k] - distance <= b.upper[k] &&
                  b.lower[k] <= a.upper[k] + distance;
  }
  return are_within;
}

// Sorts pairs by the first triangle, and then by the place of the second one in
// the tree: neighbours follow each other, and so do their planes in memory.
void SortByPlace(const TriangleBvh& tree,
                 std::vector<std::pair<int, int>>* pairs) {
  std::vector<int> places(tree.num_triangles());
  int place = 0;
  tree.Traverse([](const Box3&) { return true; },
                [&](int triangle) { places[triangle] = place++; });
  std::sort(pairs->begin(), pairs->end(), [&](const auto& a, const auto& b) {
    return std::make_pair(a.first, places[a.second]) <
           std::make_pair(b.first, places[b.second]);
  });
}

// Returns the plane between two triangles of a muscle for their separation.
SeparatingPlane PlaneAt(const StepOptions& options,
                        const ContactStep& step,
                        int muscle,
                        int f,
                        int g,
                        const TriangleSeparation& separation) {
  const double half_gap =
      std::min(options.gap,
               options.defects.sheet_fraction * separation.distance) /
      2;
  SeparatingPlane plane =
      PlaneBetween(step, muscle, f, muscle, g, separation, half_gap);
  const RowVector3i b = step.scene.muscles[muscle].triangles.row(g);
  for (const int corner : step.scene.muscles[muscle].triangles.row(f)) {
    if ((b.array() == corner).any()) plane.shared_corner = corner;
  }
  if (plane.shared_corner < 0) return plane;
  // The shared corner lies on the plane; a second copy of another corner
  // replaces it.
  for (RowVector3i* corners : {&plane.above, &plane.below}) {
    const int other = (*corners)[0] == plane.shared_corner ? 1 : 0;
    for (int k = 0; k < 3; ++k) {
      if ((*corners)[k] == plane.shared_corner)
        (*corners)[k] = (*corners)[other];
    }
  }
  return plane;
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
  if (const auto before = SeparateSheets(step.before.points[muscle], a, b)) {
    return PlaneAt(options, step, muscle, f, g, *before);
  }
  const auto at_targets = SeparateSheets(targets, a, b);
  if (!at_targets) return std::nullopt;
  SeparatingPlane plane = PlaneAt(options, step, muscle, f, g, *at_targets);
  plane.normal = at_targets->normal;
  return plane;
}

std::vector<SeparatingPlane> FindPlanesBetweenSheets(const StepOptions& options,
                                                     const ContactStep& step,
                                                     int muscle) {
  const ScopedStage stage("planes within muscles");
  const double distance = options.planes.sheet_distance;
  const TriangleBvh& tree = step.trees_before[muscle];
  const Triangles& triangles = step.scene.muscles[muscle].triangles;
  const Points& before = step.before.points[muscle];
  const Points normals = UnitNormals(tree);
  const std::vector<Box3> normals_of_nodes = NormalsOfNodes(tree, normals);
  // Prunes nodes whose triangles face the same way, as those of neighbours do.
  std::vector<std::pair<int, int>> facing = tree.CollectSelfPairs(
      [&](int a, int b) {
        return AreWithin(tree.node_box(a), tree.node_box(b), distance) &&
               LeastProduct(normals_of_nodes[a], normals_of_nodes[b]) < 0;
      },
      [&](int f, int g) {
        return normals.row(f).dot(normals.row(g)) < 0 &&
               BoxOf(tree.corners(g))
                   .Overlaps(BoxOf(tree.corners(f), distance)) &&
               !ShareAnEdge(triangles.row(f), triangles.row(g));
      });
  SortByPlace(tree, &facing);
  CountWork(WorkUnit::kPairsTested, static_cast<std::int64_t>(facing.size()));
  std::vector<std::optional<SeparatingPlane>> found(facing.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (size_t i = 0; i < facing.size(); ++i) {
    const auto [f, g] = facing[i];
    const auto separation =
        SeparateSheets(before, triangles.row(f), triangles.row(g));
    if (separation && separation->distance <= distance &&
        FaceEachOther(normals.row(f),
                      normals.row(g),
                      separation->normal,
                      options.planes.min_facing)) {
      found[i] = PlaneAt(options, step, muscle, f, g, *separation);
    }
  }
  std::vector<SeparatingPlane> planes;
  for (const auto& plane : found) {
    if (plane) planes.push_back(*plane);
  }
  return planes;
}

}  // namespace musclewarp
