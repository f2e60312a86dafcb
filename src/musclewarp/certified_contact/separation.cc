// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "musclewarp/geometry/triangle_distance.h"
#include "musclewarp/geometry/triangle_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Below this, mm, the direction between two triangles is rounding.
constexpr double kTouching = 1e-7;

// What lies higher than the obstacle that a plane is of by this part of the gap
// needs no plane of its own.
constexpr double kShareOfGap = 0.25;

// A plane with triangles behind it: normal . p <= level.
struct Plane {
  RowVector3d normal = RowVector3d::Zero();
  double level = 0;

  bool IsBehind(const Corners& t) const {
    return normal.dot(t.row(0)) <= level && normal.dot(t.row(1)) <= level &&
           normal.dot(t.row(2)) <= level;
  }
};

}  // namespace

void PartFromObstacles(const Corners& triangle,
                       const TriangleBvh& obstacles,
                       const int* near,
                       int num_near,
                       double radius,
                       double gap,
                       std::vector<HalfSpace>* spaces) {
  constexpr int kMaxPlanes = 24;  // a corner in a rugged pit has fewer
  struct Candidate {
    double square;  // of the distance of the boxes
    int triangle;
    bool is_done;
  };
  const Box3 box = BoxOf(triangle);
  const double most = radius * radius;
  std::vector<Candidate> left;
  left.reserve(num_near);
  for (int i = 0; i < num_near; ++i) {
    const double square =
        BoxOf(obstacles.corners(near[i])).SquaredDistance(box);
    if (square <= most) left.push_back({square, near[i], false});
  }
  std::sort(left.begin(), left.end(), [](const auto& a, const auto& b) {
    return std::tie(a.square, a.triangle) < std::tie(b.square, b.triangle);
  });
  for (int planes = 0; planes < kMaxPlanes; ++planes) {
    // The nearest, but for those that are behind the plane of one nearly as
    // near.
    double least = std::numeric_limits<double>::infinity();
    Plane plane;
    for (Candidate& next : left) {
      if (next.square >= least) break;
      const Corners& other = obstacles.corners(next.triangle);
      if (least <= most && plane.IsBehind(other)) continue;
      const ClosestPair pair = ClosestPointsOfTriangles(triangle, other);
      if (pair.squared_distance >= least) continue;
      const double distance = std::sqrt(pair.squared_distance);
      next.is_done = distance > radius || distance < kTouching;
      if (next.is_done) continue;
      least = pair.squared_distance;
      plane.normal = (pair.on_a - pair.on_b) / distance;
      plane.level = plane.normal.dot(pair.on_b) +
                    0.5 * std::max(0.0, distance - gap) + kShareOfGap * gap;
    }
    if (least > most) break;
    spaces->push_back({plane.normal, plane.level + (1 - kShareOfGap) * gap});
    left.erase(std::remove_if(left.begin(),
                              left.end(),
                              [&](const Candidate& candidate) {
                                return candidate.is_done ||
                                       plane.IsBehind(obstacles.corners(
                                           candidate.triangle));
                              }),
               left.end());
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
