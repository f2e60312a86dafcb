// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/long_axis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace musclewarp {

Points LongAxis(const Points& points, const Triangles& triangles) {
  // Near the mesh, so that squares lose no digits.
  const Eigen::RowVector3d origin = points.row(0);
  double area = 0;
  Eigen::RowVector3d first = Eigen::RowVector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Eigen::RowVector3d a = points.row(triangles(f, 0)) - origin;
    const Eigen::RowVector3d b = points.row(triangles(f, 1)) - origin;
    const Eigen::RowVector3d c = points.row(triangles(f, 2)) - origin;
    const Eigen::RowVector3d sum = a + b + c;
    const double part = (b - a).cross(c - a).norm() / 2;
    area += part;
    first += part / 3 * sum;
    // The integral of x x^T over a triangle.
    second += part / 12 *
              (a.transpose() * a + b.transpose() * b + c.transpose() * c +
               sum.transpose() * sum);
  }
  const Eigen::RowVector3d middle = first / area;
  const Eigen::Matrix3d spread = second / area - middle.transpose() * middle;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Eigen::RowVector3d axis = solver.eigenvectors().col(2).transpose();
  const Eigen::VectorXd along =
      (points.rowwise() - (origin + middle)) * axis.transpose();
  Points ends(2, 3);
  ends.row(0) = origin + middle + along.minCoeff() * axis;
  ends.row(1) = origin + middle + along.maxCoeff() * axis;
  return ends;
}

}  // namespace musclewarp
