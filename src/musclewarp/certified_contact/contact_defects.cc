// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// What ContactRelaxation does about triangles that cross or fold all the same.
#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "musclewarp/certified_contact/contact_relaxation.h"
#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/geometry/triangle_distance.h"
#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::RowVector3i;

// Two sheets of a muscle keep this part of the distance they have.
constexpr double kSheetRoom = 0.5;

// What crosses itself or folds moves more as one piece in the next round, by
// this factor on the weights of its edges, up to a limit.
constexpr double kStiffer = 10;
constexpr double kStiffest = 1e4;

// A triangle that folded keeps this part of the height its target has.
constexpr double kUnfoldedHeight = 0.1;

// How two triangles of a mesh are parted: the direction from b to a and by how
// much, mm; by nothing if they are not. Of triangles with a common corner the
// other corners are parted, by the direction that all edges from there follow
// best: that to the point nearest to the origin of the hull of the directions
// of the edges of a and of those of b reversed.
RowVector3d PartSheets(const Points& points,
                       const RowVector3i& a,
                       const RowVector3i& b,
                       double* distance) {
  *distance = 0;
  Eigen::Matrix<double, 4, 3> edges;
  int common = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (a[i] != b[j]) continue;
      ++common;
      for (int k = 0; k < 2; ++k) {
        const RowVector3d corner = points.row(a[i]);
        edges.row(k) = points.row(a[(i + 1 + k) % 3]) - corner;
        edges.row(2 + k) = corner - points.row(b[(j + 1 + k) % 3]);
      }
    }
  }
  if (common == 0) {
    PartedPair pair;
    if (Part(CornersOf(points, a), CornersOf(points, b), &pair)) {
      *distance = pair.distance;
    }
    return pair.normal;
  }
  if (common > 1) return RowVector3d::Zero();
  const Eigen::Matrix<double, 4, 3> directions = edges.rowwise().normalized();
  RowVector3d nearest = RowVector3d::Constant(1);
  for (int left_out = 0; left_out < 4; ++left_out) {
    Corners face;
    for (int k = 0; k < 3; ++k) {
      face.row(k) = directions.row((left_out + 1 + k) % 4);
    }
    const RowVector3d point = ClosestPointOfTriangle(RowVector3d::Zero(), face);
    if (point.norm() < nearest.norm()) nearest = point;
  }
  const RowVector3d normal = nearest.stableNormalized();
  *distance = (edges * normal.transpose()).minCoeff();
  return normal;
}

}  // namespace

// Two triangles of a muscle that cross: apart as they were before or, if they
// crossed then, as their targets are.
bool ContactRelaxation::AddSheetPlane(int muscle, int f, int g) {
  Plane plane;
  plane.muscle_a = plane.muscle_b = muscle;
  plane.a = muscles_[muscle].triangles.row(f);
  plane.b = muscles_[muscle].triangles.row(g);
  const RowVector3d before =
      PartSheets(clean_[muscle], plane.a, plane.b, &plane.distance);
  if (plane.distance > 0) {
    plane.normal = Turned(muscle, f, muscle, g, before);
  } else {
    plane.normal =
        PartSheets(targets_[muscle], plane.a, plane.b, &plane.distance);
    if (!(plane.distance > 0)) return false;
  }
  plane.half_gap = std::min(options_.gap, kSheetRoom * plane.distance) / 2;
  // The common corner stays on the plane.
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (plane.a[i] == plane.b[j]) plane.corner = plane.a[i];
    }
  }
  if (plane.corner >= 0) {
    for (RowVector3i* corners : {&plane.a, &plane.b}) {
      const int other = (*corners)[0] == plane.corner ? 1 : 0;
      for (int k = 0; k < 3; ++k) {
        if ((*corners)[k] == plane.corner) (*corners)[k] = (*corners)[other];
      }
    }
  }
  AddPlane(plane);
  return true;
}

void ContactRelaxation::Stiffen(int muscle, const std::vector<int>& triangles) {
  std::vector<bool> is_stiffer(muscles_[muscle].num_vertices(), false);
  for (const int f : triangles) {
    for (const int v : muscles_[muscle].triangles.row(f)) is_stiffer[v] = true;
  }
  for (int v = 0; v < muscles_[muscle].num_vertices(); ++v) {
    if (!is_stiffer[v]) continue;
    stiffness_[muscle][v] =
        std::min(kStiffer * stiffness_[muscle][v], kStiffest);
  }
}

int ContactRelaxation::AddSelfCrossings(int muscle) {
  const auto pairs = SelfIntersections(*trees_[muscle]);
  if (static_cast<int>(pairs.size()) <= muscles_[muscle].self_pairs) return 0;
  int parted = 0;
  std::vector<int> triangles;
  for (const auto& [f, g] : pairs) {
    if (!AddSheetPlane(muscle, f, g)) continue;
    ++parted;
    triangles.push_back(f);
    triangles.push_back(g);
  }
  Stiffen(muscle, triangles);
  return parted;
}

int ContactRelaxation::AddMuscleCrossings(int a, int b) {
  const auto pairs = IntersectingTriangles(*trees_[a], *trees_[b]);
  const int count = static_cast<int>(pairs.size());
  for (const auto& [f, g] : pairs) {
    PartedPair pair;
    if (Part(clean_trees_[a]->corners(f), clean_trees_[b]->corners(g), &pair)) {
      pair.a = f;
      pair.b = g;
      AddPlane(PlaneOf(a, b, pair));
    }
  }
  return count;
}

int ContactRelaxation::AddBoneCrossings(int bone) {
  const Eigen::Matrix4d rest_from_before = RigidInverse(bones_before_[bone]);
  const Eigen::Matrix4d rest_from_now = RigidInverse(bones_[bone]);
  int count = 0;
  for (int i = 0; i < num_muscles(); ++i) {
    trees_[i]->Refit(Transformed(points_[i], rest_from_now));
    for (const auto& [f, g] :
         IntersectingTriangles(*trees_[i], *rest_bones_[bone])) {
      if (muscles_[i].IsExempt(bone, f)) continue;
      ++count;
      const Corners at_rest = Transformed(
          CornersOf(clean_[i], muscles_[i].triangles.row(f)), rest_from_before);
      PartedPair pair;
      const Corners& obstacle = rest_bones_[bone]->corners(g);
      if (!Part(at_rest, obstacle, &pair)) continue;
      const double level = (obstacle * pair.normal.transpose()).maxCoeff();
      AddBonePlane(i, f, bone, {pair.normal, level + options_.gap});
    }
  }
  return count;
}

int ContactRelaxation::AddFolded(int muscle) {
  const Triangles& triangles = muscles_[muscle].triangles;
  std::vector<int> folded;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Corners now = CornersOf(points_[muscle], triangles.row(f));
    const Corners target = CornersOf(targets_[muscle], triangles.row(f));
    if (AreaVector(now).dot(AreaVector(target)) < 0) {
      folded.push_back(static_cast<int>(f));
    }
  }
  const auto count = static_cast<double>(triangles.rows());
  if (static_cast<double>(folded.size()) <= options_.max_folded_share * count) {
    return 0;
  }
  Stiffen(muscle, folded);
  for (const int f : folded) {
    // Over its longest edge a triangle is lowest, and folds.
    const RowVector3i corners = triangles.row(f);
    const Corners target = CornersOf(targets_[muscle], corners);
    int top = 0;
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      const double length =
          (target.row((k + 1) % 3) - target.row((k + 2) % 3)).norm();
      if (length > longest) {
        longest = length;
        top = k;
      }
    }
    const RowVector3d area = AreaVector(target);
    const int u = (top + 1) % 3, v = (top + 2) % 3;
    const RowVector3d inward =
        area.cross(RowVector3d(target.row(v) - target.row(u)));
    if (!(inward.norm() > 0)) continue;
    const double height = area.norm() / longest;
    Plane plane;
    plane.muscle_a = plane.muscle_b = muscle;
    plane.a = RowVector3i::Constant(corners[top]);
    plane.b = RowVector3i(corners[u], corners[v], corners[v]);
    plane.normal = inward.normalized();
    plane.half_gap = kUnfoldedHeight * height / 2;
    plane.distance = height;
    AddPlane(plane);
  }
  return static_cast<int>(folded.size());
}

StateDefects ContactRelaxation::AddDefects() {
  StateDefects found;
  const size_t planes = planes_.size();
  for (int i = 0; i < num_muscles(); ++i) {
    trees_[i]->Refit(points_[i]);
    found.folded += AddFolded(i);
  }
  for (int a = 0; a < num_muscles(); ++a) {
    found.self_pairs += AddSelfCrossings(a);
    for (int b = a + 1; b < num_muscles(); ++b) {
      found.crossing_pairs += AddMuscleCrossings(a, b);
    }
  }
  for (size_t bone = 0; bone < bones_.size(); ++bone) {
    found.crossing_pairs += AddBoneCrossings(static_cast<int>(bone));
  }
  if (planes_.size() > planes || found.crossing_pairs > 0) SortSides();
  return found;
}

}  // namespace musclewarp
