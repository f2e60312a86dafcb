// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/initial_separation.h"

#include <Eigen/Geometry>
#include <memory>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

RowVector3d UnitNormal(const Corners& t) {
  const RowVector3d n =
      RowVector3d(t.row(1) - t.row(0)).cross(RowVector3d(t.row(2) - t.row(0)));
  const double norm = n.norm();
  return norm > 0 ? RowVector3d(n / norm) : RowVector3d::Zero();
}

// Directions in which the vertices of a muscle should go.
struct Pushes {
  Points sum;
  Eigen::VectorXd count;

  explicit Pushes(Eigen::Index vertices)
      : sum(Points::Zero(vertices, 3)),
        count(Eigen::VectorXd::Zero(vertices)) {}
};

}  // namespace

InitialSeparation SeparateInitially(
    const std::vector<const SearchableMesh*>& muscles,
    const std::vector<const SearchableMesh*>& bones,
    const std::vector<ExemptArea>& exempt,
    const InitialSeparationOptions& options) {
  InitialSeparation result;
  const size_t count = muscles.size();
  std::vector<OwnRegion> regions;
  std::vector<std::unique_ptr<TriangleBvh>> trees;
  for (size_t i = 0; i < count; ++i) {
    std::vector<const SearchableMesh*> others;
    for (size_t j = 0; j < count; ++j) {
      if (j != i) others.push_back(muscles[j]);
    }
    regions.emplace_back(options.region, *muscles[i], others, bones);
    result.points.push_back(regions[i].Project(muscles[i]->points()));
    for (const ExemptArea& area : exempt) {
      if (area.muscle != static_cast<int>(i)) continue;
      for (Eigen::Index v = 0; v < result.points[i].rows(); ++v) {
        if (!area.vertices[v]) continue;
        result.points[i].row(v) = muscles[i]->points().row(v);
      }
    }
    trees.push_back(std::make_unique<TriangleBvh>(result.points[i],
                                                  muscles[i]->triangles()));
  }
  // The triangle f of muscle i crosses `other`.
  const auto push = [&](size_t i, int f, const Corners& other, Pushes* pushes) {
    RowVector3d inward = RowVector3d::Zero();
    const auto t = muscles[i]->triangles().row(f);
    for (int k = 0; k < 3; ++k) {
      inward += regions[i].Inward(result.points[i].row(t[k]));
    }
    const RowVector3d normal = UnitNormal(other);
    RowVector3d direction = normal.dot(inward) > 0.2 ? normal : inward;
    if (direction.norm() == 0) direction = normal;
    direction.normalize();
    for (int k = 0; k < 3; ++k) {
      pushes->sum.row(t[k]) += direction;
      pushes->count[t[k]] += 1;
    }
  };
  for (;; ++result.rounds) {
    result.crossing_pairs = 0;
    std::vector<Pushes> pushes;
    for (size_t i = 0; i < count; ++i) {
      pushes.emplace_back(result.points[i].rows());
    }
    for (size_t i = 0; i < count; ++i) {
      for (size_t j = i + 1; j < count; ++j) {
        for (const auto& [f, g] : IntersectingTriangles(*trees[i], *trees[j])) {
          ++result.crossing_pairs;
          push(i, f, trees[j]->corners(g), &pushes[i]);
          push(j, g, trees[i]->corners(f), &pushes[j]);
        }
      }
      for (size_t b = 0; b < bones.size(); ++b) {
        const ExemptArea* area =
            FindExempt(exempt, static_cast<int>(i), static_cast<int>(b));
        for (const auto& [f, g] :
             IntersectingTriangles(*trees[i], bones[b]->bvh())) {
          if (area && area->triangles[f]) continue;
          ++result.crossing_pairs;
          push(i, f, bones[b]->bvh().corners(g), &pushes[i]);
        }
      }
    }
    if (result.crossing_pairs == 0 || result.rounds == options.max_rounds) {
      return result;
    }
    for (size_t i = 0; i < count; ++i) {
      Points& points = result.points[i];
      std::vector<int> pushed;
      for (Eigen::Index v = 0; v < points.rows(); ++v) {
        if (pushes[i].count[v] > 0) pushed.push_back(static_cast<int>(v));
      }
      // What lies near goes along, or thin parts would be pushed through
      // themselves.
      const double reach = 3;
      Points moves = Points::Zero(points.rows(), 3);
#pragma omp parallel for schedule(dynamic, 256)
      for (Eigen::Index v = 0; v < points.rows(); ++v) {
        RowVector3d sum = RowVector3d::Zero();
        double weights = 0, most = 0;
        for (const int u : pushed) {
          const double d = (points.row(u) - points.row(v)).norm();
          if (d >= reach) continue;
          const double w = (1 - d / reach) * (1 - d / reach);
          sum += w * pushes[i].sum.row(u) / pushes[i].count[u];
          weights += w;
          most = std::max(most, 1 - d / reach);
        }
        if (weights > 0) moves.row(v) = options.step * most / weights * sum;
      }
      points += moves;
      trees[i]->Refit(points);
    }
  }
}

}  // namespace musclewarp
