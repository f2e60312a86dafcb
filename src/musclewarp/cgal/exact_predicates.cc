// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/exact_predicates.h"

#include "musclewarp/cgal/cgal_mesh.h"

namespace musclewarp::internal {

int ExactOrientation(const Eigen::RowVector3d& a,
                     const Eigen::RowVector3d& b,
                     const Eigen::RowVector3d& c,
                     const Eigen::RowVector3d& d) {
  const auto point = [](const Eigen::RowVector3d& p) {
    return CgalKernel::Point_3(p[0], p[1], p[2]);
  };
  return CGAL::orientation(point(a), point(b), point(c), point(d));
}

int ExactOrientation2d(
    double ax, double ay, double bx, double by, double cx, double cy) {
  return CGAL::orientation(CgalKernel::Point_2(ax, ay),
                           CgalKernel::Point_2(bx, by),
                           CgalKernel::Point_2(cx, cy));
}

}  // namespace musclewarp::internal
