// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_surfaces.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/exchange/near_triangles.h"
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
  std::vector<const TriangleBvh*> trees;
  for (const TriangleBvh& surface : surfaces) trees.push_back(&surface);
  const std::vector<bool> is_near = TrianglesWithin(reach, soup, trees);
  std::vector<bool> is_corner(soup.points.rows(), false);
  for (size_t f = 0; f < is_near.size(); ++f) {
    if (!is_near[f]) continue;
    for (const int v : soup.triangles.row(f)) is_corner[v] = true;
  }
  return is_corner;
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

void BoneCoarsening::AddPose(const RecordedPose& pose) {
  is_kept_.resize(pose.bones.size());
  const std::vector<TriangleBvh> muscles = TreesOf(pose.muscles);
  for (size_t i = 0; i < pose.bones.size(); ++i) {
    const std::vector<bool> is_near =
        VerticesWithin(reach_, pose.bones[i], muscles);
    is_kept_[i].resize(is_near.size(), false);
    for (size_t v = 0; v < is_near.size(); ++v) {
      if (is_near[v]) is_kept_[i][v] = true;
    }
  }
}

double BoneCoarsening::Coarsen(double tolerance, const RecordedPose& pose) {
  CHECK_EQ(is_kept_.size(), pose.bones.size());
  coarse_.resize(pose.bones.size());
  std::vector<double> errors(pose.bones.size(), 0);
  ParallelFor(pose.bones.size(), [&](size_t i) {
    DecimationOptions options;
    options.tolerance = tolerance;
    options.is_kept = is_kept_[i];
    Decimation coarse = Decimated(pose.bones[i], options);
    errors[i] = coarse.max_error;
    coarse_[i] = {std::move(coarse.vertices), std::move(coarse.soup.triangles)};
  });
  return errors.empty() ? 0 : *std::max_element(errors.begin(), errors.end());
}

void BoneCoarsening::Apply(RecordedPose* pose) const {
  for (size_t i = 0; i < coarse_.size(); ++i) {
    TriangleSoup& bone = pose->bones[i];
    bone.points = Points(bone.points(coarse_[i].vertices, Eigen::all));
    bone.triangles = coarse_[i].triangles;
  }
}

MuscleRemeshing RemeshMuscles(double edge_length,
                              double body_size,
                              const RecordedNames& names,
                              RecordedPose* pose,
                              RecordedAttachments* attachments) {
  const std::vector<TriangleSoup> before = pose->muscles;
  ParallelFor(before.size(), [&](size_t i) {
    pose->muscles[i] = RemeshedWithoutCrossings(before[i], edge_length);
  });
  MuscleRemeshing result;
  for (size_t i = 0; i < before.size(); ++i) {
    const Triangles& triangles = pose->muscles[i].triangles;
    if (triangles.rows() == before[i].triangles.rows() &&
        triangles == before[i].triangles) {
      result.unchanged.push_back(names.muscles[i]);
    }
  }
  MoveApart(body_size, names, pose);

  const std::vector<TriangleBvh> old_trees = TreesOf(before);
  for (size_t i = 0; i < before.size(); ++i) {
    const TriangleSoup& soup = pose->muscles[i];
    const TriangleBvh tree(soup.points, soup.triangles);
    for (Eigen::Index v = 0; v < before[i].points.rows(); ++v) {
      result.max_error =
          std::max(result.max_error,
                   tree.ClosestPoint(before[i].points.row(v)).distance);
    }
    const auto areas = attachments->muscles.find(names.muscles[i]);
    if (areas == attachments->muscles.end()) continue;
    for (AttachedArea& area : areas->second) {
      area.vertices =
          Transferred(area.vertices, before[i], old_trees[i], soup.points);
    }
  }
  return result;
}

}  // namespace musclewarp
