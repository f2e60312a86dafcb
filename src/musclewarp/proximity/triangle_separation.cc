// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/triangle_separation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "musclewarp/cgal/triangle_intersection.h"
#include "musclewarp/proximity/triangle_distance.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::RowVector3i;

// Below this, mm, the direction between two triangles is rounding.
constexpr double kTouching = 1e-7;

// True if all corners have normal . p <= level.
bool IsBehind(const Corners& t, const HalfSpace& plane) {
  return plane.normal.dot(t.row(0)) <= plane.level &&
         plane.normal.dot(t.row(1)) <= plane.level &&
         plane.normal.dot(t.row(2)) <= plane.level;
}

// A triangle of an obstacle that may need a plane.
struct Candidate {
  double square;  // of the distance of the boxes, mm^2
  int triangle;
  bool is_done;
};

// Nearest first.
std::vector<Candidate> CandidatesNear(const Corners& triangle,
                                      const TriangleBvh& obstacles,
                                      const int* near,
                                      int num_near,
                                      double radius) {
  const Box3 box = BoxOf(triangle);
  std::vector<Candidate> candidates;
  candidates.reserve(num_near);
  for (int i = 0; i < num_near; ++i) {
    const double square =
        BoxOf(obstacles.corners(near[i])).SquaredDistance(box);
    if (square <= radius * radius) {
      candidates.push_back({square, near[i], false});
    }
  }
  std::sort(candidates.begin(),
            candidates.end(),
            [](const Candidate& a, const Candidate& b) {
              return std::tie(a.square, a.triangle) <
                     std::tie(b.square, b.triangle);
            });
  return candidates;
}

// Returns true if a plane orthogonal to `direction` shows that two triangles
// are farther apart than the root of `square`, mm^2.
bool AreApartAlong(const RowVector3d& direction,
                   const Corners& a,
                   const Corners& b,
                   double square) {
  double highest_of_a = 0, lowest_of_b = direction.dot(b.row(0) - a.row(0));
  double lowest_of_a = 0, highest_of_b = lowest_of_b;
  for (const int i : {1, 2}) {
    const double of_a = direction.dot(a.row(i) - a.row(0));
    const double of_b = direction.dot(b.row(i) - a.row(0));
    highest_of_a = std::max(highest_of_a, of_a);
    lowest_of_a = std::min(lowest_of_a, of_a);
    highest_of_b = std::max(highest_of_b, of_b);
    lowest_of_b = std::min(lowest_of_b, of_b);
  }
  const double gap =
      std::max(lowest_of_b - highest_of_a, lowest_of_a - highest_of_b);
  // More than rounding may be wrong by.
  constexpr double kSafety = 1 + 1e-9;
  return gap > 0 && gap * gap > kSafety * square * direction.squaredNorm();
}

}  // namespace

bool AreSurelyFarther(const Corners& a, const Corners& b, double square) {
  return AreApartAlong(AreaVector(b), a, b, square) ||
         AreApartAlong(b.colwise().sum() - a.colwise().sum(), a, b, square);
}

std::optional<TriangleSeparation> SeparateTriangles(const Corners& a,
                                                    const Corners& b) {
  // Always in the same order, so that rounding cannot depend on it.
  if (std::lexicographical_compare(
          b.data(), b.data() + 9, a.data(), a.data() + 9)) {
    std::optional<TriangleSeparation> separation = SeparateTriangles(b, a);
    if (separation) separation->normal = -separation->normal;
    return separation;
  }
  const ClosestPair closest = ClosestPointsOfTriangles(a, b);
  const double distance = std::sqrt(closest.squared_distance);
  if (distance < kTouching || TrianglesIntersect(a, b)) return std::nullopt;
  return TriangleSeparation{(closest.on_a - closest.on_b) / distance, distance};
}

std::optional<TriangleSeparation> SeparateSheets(const Points& points,
                                                 const RowVector3i& a,
                                                 const RowVector3i& b) {
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
    return SeparateTriangles(CornersOf(points, a), CornersOf(points, b));
  }
  if (common > 1) return std::nullopt;
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
  const double distance = (edges * normal.transpose()).minCoeff();
  if (!(distance > 0)) return std::nullopt;
  return TriangleSeparation{normal, distance};
}

ObstacleSeparation SeparateFromObstacles(const Corners& triangle,
                                         const TriangleBvh& obstacles,
                                         const int* near,
                                         int num_near,
                                         const ObstacleOptions& options) {
  const double most = options.radius * options.radius;
  const double overlooked = options.overlooked_fraction * options.gap;
  std::vector<Candidate> left =
      CandidatesNear(triangle, obstacles, near, num_near, options.radius);
  ObstacleSeparation separation;
  for (int planes = 0; planes < options.max_planes; ++planes) {
    // The nearest triangle, but for those behind the plane of one nearly as
    // near.
    double least = std::numeric_limits<double>::infinity();
    double nearest = least;  // of what is behind it, at least
    HalfSpace plane;
    for (Candidate& next : left) {
      if (next.square >= least) break;
      const Corners& other = obstacles.corners(next.triangle);
      if (least <= most && IsBehind(other, plane)) {
        nearest = std::min(nearest, next.square);
        continue;
      }
      if (AreSurelyFarther(triangle, other, std::min(least, most))) {
        next.is_done = least > most;
        continue;
      }
      const ClosestPair pair = ClosestPointsOfTriangles(triangle, other);
      if (pair.squared_distance >= least) continue;
      const double distance = std::sqrt(pair.squared_distance);
      separation.touches |= distance < kTouching;
      next.is_done = distance > options.radius || distance < kTouching;
      if (next.is_done) continue;
      least = pair.squared_distance;
      plane.normal = (pair.on_a - pair.on_b) / distance;
      plane.level = plane.normal.dot(pair.on_b) +
                    0.5 * std::max(0.0, distance - options.gap) + overlooked;
    }
    if (least > most) break;
    if (planes == 0) {
      separation.distance = std::sqrt(std::min(least, nearest));
      separation.distance_of_first = std::sqrt(least);
    }
    separation.spaces.push_back(
        {plane.normal,
         plane.level + (1 - options.overlooked_fraction) * options.gap});
    left.erase(
        std::remove_if(left.begin(),
                       left.end(),
                       [&](const Candidate& candidate) {
                         return candidate.is_done ||
                                IsBehind(obstacles.corners(candidate.triangle),
                                         plane);
                       }),
        left.end());
  }
  return separation;
}

}  // namespace musclewarp
