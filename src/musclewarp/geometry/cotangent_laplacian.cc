// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/cotangent_laplacian.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace musclewarp {
namespace {

// Returns the cotangent of the angle at `apex`, bounded to [-bound, bound].
double BoundedCotangent(const Eigen::RowVector3d& apex,
                        const Eigen::RowVector3d& a,
                        const Eigen::RowVector3d& b,
                        double bound) {
  const Eigen::RowVector3d to_a = a - apex;
  const Eigen::RowVector3d to_b = b - apex;
  const double cosine = to_a.dot(to_b);
  const double sine = to_a.cross(to_b).norm();
  if (std::abs(cosine) >= bound * sine) return cosine < 0 ? -bound : bound;
  return cosine / sine;
}

}  // namespace

bool CotangentLaplacianOptions::IsValid(std::string* error) const {
  if (!(min_angle > 0 && min_angle < 1)) {
    *error = "CotangentLaplacianOptions::min_angle is " +
             std::to_string(min_angle) + ", allowed: between 0 and 1 rad";
    return false;
  }
  if (!(min_weight > 0)) {
    *error = "CotangentLaplacianOptions::min_weight is " +
             std::to_string(min_weight) + ", allowed: above 0";
    return false;
  }
  return true;
}

SparseMatrix CotangentLaplacian(const Points& points,
                                const Triangles& triangles,
                                const CotangentLaplacianOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const double bound = 1 / std::tan(options.min_angle);

  // Each triangle of an edge adds the cotangent of the angle opposite to it.
  std::map<std::pair<int, int>, double> edge_weights;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int apex = triangles(f, corner);
      const int a = triangles(f, (corner + 1) % 3);
      const int b = triangles(f, (corner + 2) % 3);
      edge_weights[std::minmax(a, b)] += BoundedCotangent(
          points.row(apex), points.row(a), points.row(b), bound);
    }
  }

  Eigen::VectorXd row_sums = Eigen::VectorXd::Zero(points.rows());
  for (auto& [edge, weight] : edge_weights) {
    weight = std::max(weight, options.min_weight);
    row_sums[edge.first] += weight;
    row_sums[edge.second] += weight;
  }

  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * edge_weights.size() + points.rows());
  const auto row_scale = [&](int row) {
    return options.normalize_rows ? 1 / row_sums[row] : 1.0;
  };
  for (const auto& [edge, weight] : edge_weights) {
    const auto [a, b] = edge;
    entries.emplace_back(a, b, weight * row_scale(a));
    entries.emplace_back(b, a, weight * row_scale(b));
  }
  for (int i = 0; i < points.rows(); ++i) {
    if (row_sums[i] > 0)
      entries.emplace_back(i, i, -row_sums[i] * row_scale(i));
  }
  SparseMatrix laplacian(points.rows(), points.rows());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

}  // namespace musclewarp
