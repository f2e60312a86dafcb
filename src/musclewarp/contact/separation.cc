// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/contact/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "musclewarp/geometry/triangle_distance.h"
#include "musclewarp/geometry/triangle_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Below this, mm, the direction between two triangles is rounding.
constexpr double kTouching = 1e-7;

// A plane with triangles behind it: normal . p <= level.
struct Plane {
  RowVector3d normal;
  double level;

  bool IsBehind(const Corners& t) const {
    return normal.dot(t.row(0)) <= level && normal.dot(t.row(1)) <= level &&
           normal.dot(t.row(2)) <= level;
  }
  bool IsBehind(const Box3& box) const {
    double top = 0;
    for (int k = 0; k < 3; ++k) {
      top += normal[k] * (normal[k] > 0 ? box.upper[k] : box.lower[k]);
    }
    return top <= level;
  }
};

Box3 BoxOf(const Corners& triangle) {
  Box3 box;
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = triangle.col(k).minCoeff();
    box.upper[k] = triangle.col(k).maxCoeff();
  }
  return box;
}

double SquaredDistance(const Box3& a, const Box3& b) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap =
        std::max({a.lower[k] - b.upper[k], b.lower[k] - a.upper[k], 0.0});
    sum += gap * gap;
  }
  return sum;
}

}  // namespace

void PartFromObstacles(const Corners& triangle,
                       const TriangleBvh& obstacles,
                       double radius,
                       double gap,
                       std::vector<HalfSpace>* spaces) {
  constexpr int kMaxPlanes = 24;  // a corner in a rugged pit has fewer
  const Box3 box = BoxOf(triangle);
  std::array<Plane, kMaxPlanes> planes;
  std::array<int, kMaxPlanes> done;  // their triangles, and those that touch
  int num_planes = 0, num_done = 0;
  const auto is_behind = [&](const auto& what) {
    for (int i = 0; i < num_planes; ++i) {
      if (planes[i].IsBehind(what)) return true;
    }
    return false;
  };
  constexpr double kFar = std::numeric_limits<double>::infinity();
  while (num_done < kMaxPlanes) {
    double least = radius * radius;
    int nearest = -1;
    ClosestPair pair;
    obstacles.TraverseNearestFirst(
        [&](const Box3& node) {
          return is_behind(node) ? kFar : SquaredDistance(node, box);
        },
        [&](int g) {
          const Corners& other = obstacles.corners(g);
          if (SquaredDistance(BoxOf(other), box) > least) return;
          if (is_behind(other)) return;
          if (std::find(done.begin(), done.begin() + num_done, g) !=
              done.begin() + num_done) {
            return;
          }
          const ClosestPair found = ClosestPointsOfTriangles(triangle, other);
          if (found.squared_distance > least) return;
          least = found.squared_distance;
          nearest = g;
          pair = found;
        },
        &least);
    if (nearest < 0) return;
    done[num_done++] = nearest;
    const double distance = std::sqrt(least);
    if (distance < kTouching) continue;
    const RowVector3d normal = (pair.on_a - pair.on_b) / distance;
    const double level =
        normal.dot(pair.on_b) + 0.5 * std::max(0.0, distance - gap) + 1e-9;
    planes[num_planes++] = {normal, level};
    spaces->push_back({normal, level + gap});
  }
}

bool Part(const Corners& a, const Corners& b, PartedPair* pair) {
  // Always in the same order, that rounding may not depend on it.
  if (std::lexicographical_compare(
          b.data(), b.data() + 9, a.data(), a.data() + 9)) {
    const bool are_parted = Part(b, a, pair);
    pair->normal = -pair->normal;
    return are_parted;
  }
  const ClosestPair closest = ClosestPointsOfTriangles(a, b);
  pair->distance = std::sqrt(closest.squared_distance);
  if (pair->distance < kTouching || TrianglesIntersect(a, b)) return false;
  pair->normal = (closest.on_a - closest.on_b) / pair->distance;
  return true;
}

std::vector<PartedPair> PartedPairs(const TriangleBvh& a,
                                    const TriangleBvh& b,
                                    const TriangleBvh& moved_a,
                                    const TriangleBvh& moved_b,
                                    double radius) {
  const double square = radius * radius;
  std::vector<std::vector<PartedPair>> found(a.num_triangles());
#pragma omp parallel for schedule(dynamic, 64)
  for (int f = 0; f < a.num_triangles(); ++f) {
    std::vector<int> near;
    const auto collect = [&](const Corners& mine, const TriangleBvh& theirs) {
      const Box3 box = BoxOf(mine);
      theirs.Traverse(
          [&](const Box3& node) {
            return SquaredDistance(node, box) <= square;
          },
          [&](int g) {
            if (ClosestPointsOfTriangles(mine, theirs.corners(g))
                    .squared_distance <= square) {
              near.push_back(g);
            }
          });
    };
    collect(a.corners(f), b);
    collect(moved_a.corners(f), moved_b);
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const int g : near) {
      PartedPair pair;
      if (!Part(a.corners(f), b.corners(g), &pair)) continue;
      pair.a = f;
      pair.b = g;
      found[f].push_back(pair);
    }
  }
  std::vector<PartedPair> all;
  for (const auto& part : found) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace musclewarp
