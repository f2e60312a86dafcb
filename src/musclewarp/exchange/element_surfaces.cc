// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_surfaces.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/exchange/searchable_scene.h"
#include "musclewarp/geometry/decimation.h"
#include "musclewarp/geometry/remeshing.h"
#include "musclewarp/initial_separation/initial_separation.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {
namespace {

// Returns for each vertex whether it is a corner of a triangle that may be
// within `reach` of one of the surfaces.
std::vector<bool> VerticesWithin(double reach,
                                 const TriangleSoup& soup,
                                 const std::vector<TriangleBvh>& surfaces) {
  std::vector<double> longest(soup.points.rows(), 0);  // edge of each vertex
  for (const auto& t : soup.triangles.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const double length = (soup.points.row(a) - soup.points.row(b)).norm();
      longest[a] = std::max(longest[a], length);
      longest[b] = std::max(longest[b], length);
    }
  }
  // No point of a triangle is farther from a corner than its longest edge.
  std::vector<char> is_near(soup.points.rows(), 0);
#pragma omp parallel for schedule(dynamic, 256)
  for (Eigen::Index v = 0; v < soup.points.rows(); ++v) {
    for (const TriangleBvh& surface : surfaces) {
      is_near[v] |= surface.IsWithin(soup.points.row(v), reach + longest[v]);
    }
  }
  std::vector<bool> is_kept(soup.points.rows(), false);
  for (const auto& t : soup.triangles.rowwise()) {
    if (!is_near[t[0]] && !is_near[t[1]] && !is_near[t[2]]) continue;
    for (int k = 0; k < 3; ++k) is_kept[t[k]] = true;
  }
  return is_kept;
}

std::vector<TriangleBvh> TreesOf(const std::vector<TriangleSoup>& soups) {
  std::vector<TriangleBvh> trees;
  for (const TriangleSoup& soup : soups) {
    trees.emplace_back(soup.points, soup.triangles);
  }
  return trees;
}

// Returns the vertices of a new surface that are nearest to attached vertices
// of the old one.
std::vector<int> Transferred(const std::vector<int>& attached,
                             const TriangleSoup& old_soup,
                             const TriangleBvh& old_tree,
                             const Points& points) {
  std::vector<bool> is_attached(old_soup.points.rows(), false);
  for (const int v : attached) is_attached[v] = true;
  std::vector<int> vertices;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const TriangleBvh::Closest closest = old_tree.ClosestPoint(points.row(v));
    int nearest = -1;
    double distance = std::numeric_limits<double>::infinity();
    for (const int corner : old_soup.triangles.row(closest.triangle)) {
      const double to_corner =
          (old_soup.points.row(corner) - closest.point).norm();
      if (to_corner >= distance) continue;
      distance = to_corner;
      nearest = corner;
    }
    if (is_attached[nearest]) vertices.push_back(static_cast<int>(v));
  }
  return vertices;
}

// Returns the soups with lengths multiplied by a factor.
std::vector<TriangleSoup> Scaled(double factor,
                                 std::vector<TriangleSoup> soups) {
  for (TriangleSoup& soup : soups) soup.points *= factor;
  return soups;
}

// Moves the muscles of a pose until they cross neither each other nor bones, as
// far as that is possible.
void MoveApart(double body_size,
               const RecordedNames& names,
               RecordedPose* pose) {
  RecordedPose sized;
  sized.muscles = Scaled(1 / body_size, pose->muscles);
  sized.bones = Scaled(1 / body_size, pose->bones);
  const SearchableScene scene = SceneOf(names, sized);
  std::vector<const SearchableMesh*> muscles, bones;
  for (const NamedMesh& muscle : scene.muscles) muscles.push_back(muscle.mesh);
  for (const NamedMesh& bone : scene.bones) bones.push_back(bone.mesh);
  const InitialSeparation separation =
      SeparateInitially(muscles, bones, {}, InitialSeparationOptions());
  for (size_t i = 0; i < muscles.size(); ++i) {
    pose->muscles[i].points = body_size * separation.points[i];
  }
}

}  // namespace

double CoarsenBones(double tolerance, double reach, RecordedPose* pose) {
  const std::vector<TriangleBvh> muscles = TreesOf(pose->muscles);
  double max_error = 0;
  for (TriangleSoup& bone : pose->bones) {
    DecimationOptions options;
    options.tolerance = tolerance;
    options.is_kept = VerticesWithin(reach, bone, muscles);
    Decimation coarse = Decimated(bone, options);
    max_error = std::max(max_error, coarse.max_error);
    bone = std::move(coarse.soup);
  }
  return max_error;
}

double RemeshMuscles(double edge_length,
                     double body_size,
                     const RecordedNames& names,
                     RecordedPose* pose,
                     RecordedAttachments* attachments) {
  const std::vector<TriangleSoup> before = pose->muscles;
  ParallelFor(before.size(), [&](size_t i) {
    pose->muscles[i] = RemeshedWithoutCrossings(before[i], edge_length);
  });
  MoveApart(body_size, names, pose);

  const std::vector<TriangleBvh> old_trees = TreesOf(before);
  double max_error = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    const TriangleSoup& soup = pose->muscles[i];
    const TriangleBvh tree(soup.points, soup.triangles);
    for (Eigen::Index v = 0; v < before[i].points.rows(); ++v) {
      max_error = std::max(max_error,
                           tree.ClosestPoint(before[i].points.row(v)).distance);
    }
    const auto areas = attachments->muscles.find(names.muscles[i]);
    if (areas == attachments->muscles.end()) continue;
    for (AttachedArea& area : areas->second) {
      area.vertices =
          Transferred(area.vertices, before[i], old_trees[i], soup.points);
    }
  }
  return max_error;
}

}  // namespace musclewarp
