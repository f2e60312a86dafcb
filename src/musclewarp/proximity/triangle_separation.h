// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "musclewarp/mesh/triangle.h"
#include "musclewarp/proximity/half_space.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// The direction in which two triangles are apart, and how far.
struct TriangleSeparation {
  Eigen::RowVector3d normal;  // of unit length, from b to a
  double distance = 0;        // mm
};

// Returns true only if two triangles are farther apart than the root of
// `square`, mm^2: it may not see it. This settles most pairs that are far from
// each other in a fraction of the time that their closest points take.
bool AreSurelyFarther(const Corners& a, const Corners& b, double square);

// Separates two triangles by the direction of their shortest connection: planes
// orthogonal to it have a above and b below. Nothing if they touch or cross. In
// the other order the result is the same to the bit, with the normal reversed.
std::optional<TriangleSeparation> SeparateTriangles(const Corners& a,
                                                    const Corners& b);

// Separates two triangles of one mesh that may have a corner in common. Of such
// two the other corners are separated, by the direction that all edges from the
// common corner follow best: the one to the point nearest to the origin of the
// hull of the directions of the edges of a and of those of b reversed. Nothing
// if they touch or cross elsewhere, or have an edge in common. `a`, `b`:
// vertices; `points`: #V x 3, mm.
std::optional<TriangleSeparation> SeparateSheets(const Points& points,
                                                 const Eigen::RowVector3i& a,
                                                 const Eigen::RowVector3i& b);

struct ObstacleOptions {
  double radius = 1;                  // obstacles farther away are ignored, mm
  double gap = 0.1;                   // to be kept, mm
  double overlooked_fraction = 0.25;  // see PlaneSearchOptions
  int max_planes = 24;
};

// Half-spaces that keep a triangle away from obstacles.
struct ObstacleSeparation {
  std::vector<HalfSpace> spaces;  // those of the nearest obstacles first

  // A lower bound of the distance of the nearest obstacle that has a
  // half-space, mm; infinite if there is none.
  double distance = std::numeric_limits<double>::infinity();

  // The distance of the obstacle of the first half-space, mm, which may be more
  // than that of others behind it; infinite if there is none.
  double distance_of_first = std::numeric_limits<double>::infinity();

  // True if the triangle touches or crosses an obstacle, which has none.
  bool touches = false;
};

// Returns half-spaces whose common part meets none of the `num_near` triangles
// `near` of `obstacles` that are within the radius of `triangle`. All of them
// keep the gap from their obstacle, and at least the gap less its overlooked
// share from every other. Where `triangle` is farther from all obstacles than
// the gap, it lies in all half-spaces, and they leave it half of the room
// beyond.
//
// Found as in Deits and Tedrake, "Computing large convex regions of
// obstacle-free space through semidefinite programming", 2014, with a triangle
// in place of the ellipsoid: the nearest obstacle gives a plane, and everything
// behind that plane needs no other.
//
// Precondition: `triangle` crosses none of the obstacles. One that it touches
// or crosses gives no half-space.
ObstacleSeparation SeparateFromObstacles(const Corners& triangle,
                                         const TriangleBvh& obstacles,
                                         const int* near,
                                         int num_near,
                                         const ObstacleOptions& options);

}  // namespace musclewarp
