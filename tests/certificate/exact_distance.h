// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>

#include "musclewarp/cgal/triangle_intersection.h"
#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// What rounding may cost, about 120 roundings of coordinates of 10 mm.
constexpr double kTight = 2e-13;

using ExactKernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;

inline ExactKernel::Point_3 ExactPointOf(const Eigen::RowVector3d& p) {
  return {p[0], p[1], p[2]};
}

// Returns the squared distance of two triangles with area in exact arithmetic,
// by CGAL: the smallest of all pairs of edges and of corners and faces.
inline CGAL::Exact_rational ExactSquaredDistance(const Corners& a,
                                                 const Corners& b) {
  if (TrianglesIntersect(a, b)) return 0;
  ExactKernel::Point_3 p[3], q[3];
  for (int k = 0; k < 3; ++k) {
    p[k] = ExactPointOf(a.row(k));
    q[k] = ExactPointOf(b.row(k));
  }
  const ExactKernel::Triangle_3 face_a(p[0], p[1], p[2]);
  const ExactKernel::Triangle_3 face_b(q[0], q[1], q[2]);
  CGAL::Exact_rational least = CGAL::squared_distance(p[0], face_b);
  for (int i = 0; i < 3; ++i) {
    least = std::min(least, CGAL::squared_distance(p[i], face_b));
    least = std::min(least, CGAL::squared_distance(q[i], face_a));
    for (int j = 0; j < 3; ++j) {
      least = std::min(
          least,
          CGAL::squared_distance(ExactKernel::Segment_3(p[i], p[(i + 1) % 3]),
                                 ExactKernel::Segment_3(q[j], q[(j + 1) % 3])));
    }
  }
  return least;
}

}  // namespace musclewarp
