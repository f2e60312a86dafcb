// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/triangle_meets_box.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>

namespace musclewarp {

bool TriangleMeetsBox(const Corners& triangle,
                      const Eigen::RowVector3d& lower,
                      const Eigen::RowVector3d& upper) {
  using Rounded = CGAL::Simple_cartesian<double>;
  const auto corner = [&](int c) {
    return Rounded::Point_3(triangle(c, 0), triangle(c, 1), triangle(c, 2));
  };
  return CGAL::do_intersect(
      Rounded::Triangle_3(corner(0), corner(1), corner(2)),
      CGAL::Bbox_3(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]));
}

}  // namespace musclewarp
