// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/contact/separation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

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
};

}  // namespace

void PartFromObstacles(const Corners& triangle,
                       const TriangleBvh& obstacles,
                       const Box3& where,
                       double radius,
                       double gap,
                       std::vector<HalfSpace>* spaces) {
  constexpr int kMaxPlanes = 24;  // a corner in a rugged pit has fewer
  // By squared distance: of their boxes first, then, when it is their turn, of
  // themselves.
  struct Candidate {
    double square;
    int triangle;
    bool is_exact;
    ClosestPair pair;

    bool operator>(const Candidate& other) const {
      return std::tie(square, triangle) >
             std::tie(other.square, other.triangle);
    }
  };
  const Box3 box = BoxOf(triangle);
  const double most = radius * radius;
  std::vector<Candidate> heap;
  obstacles.Traverse(
      [&](const Box3& node) {
        return node.Overlaps(where) && node.SquaredDistance(box) <= most;
      },
      [&](int g) {
        const Box3 other = BoxOf(obstacles.corners(g));
        const double square = other.SquaredDistance(box);
        if (other.Overlaps(where) && square <= most) {
          heap.push_back({square, g, false, {}});
        }
      });
  std::make_heap(heap.begin(), heap.end(), std::greater<>());
  std::array<Plane, kMaxPlanes> planes;
  int num_planes = 0;
  while (!heap.empty() && num_planes < kMaxPlanes) {
    std::pop_heap(heap.begin(), heap.end(), std::greater<>());
    Candidate& next = heap.back();
    const Corners& other = obstacles.corners(next.triangle);
    bool is_done = false;
    for (int i = 0; i < num_planes && !is_done; ++i) {
      is_done = planes[i].IsBehind(other);
    }
    if (!is_done && !next.is_exact) {
      next.pair = ClosestPointsOfTriangles(triangle, other);
      next.square = next.pair.squared_distance;
      next.is_exact = true;
      if (next.square <= most) {
        std::push_heap(heap.begin(), heap.end(), std::greater<>());
        continue;
      }
      is_done = true;
    }
    const double distance = std::sqrt(next.square);
    if (!is_done && distance >= kTouching) {
      const RowVector3d normal = (next.pair.on_a - next.pair.on_b) / distance;
      const double level = normal.dot(next.pair.on_b) +
                           0.5 * std::max(0.0, distance - gap) + 1e-9;
      planes[num_planes++] = {normal, level};
      spaces->push_back({normal, level + gap});
    }
    heap.pop_back();
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
    // Those whose boxes are near first.
    std::vector<int> near;
    const auto collect = [&](const Corners& mine, const TriangleBvh& theirs) {
      const Box3 box = BoxOf(mine);
      theirs.Traverse(
          [&](const Box3& node) { return node.SquaredDistance(box) <= square; },
          [&](int g) {
            if (BoxOf(theirs.corners(g)).SquaredDistance(box) <= square) {
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
      if (pair.distance > radius &&
          ClosestPointsOfTriangles(moved_a.corners(f), moved_b.corners(g))
                  .squared_distance > square) {
        continue;
      }
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
