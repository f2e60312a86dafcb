// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/cotangent_laplacian.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "musclewarp/base/option_check.h"
#include "musclewarp/mesh/measures.h"

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

// Returns the weights w_ij of the edges, i < j.
std::map<std::pair<int, int>, double> EdgeWeights(
    const Points& points,
    const Triangles& triangles,
    const CotangentLaplacianOptions& options) {
  const double bound = 1 / std::tan(options.min_angle);
  // Each triangle of an edge adds the cotangent of the angle opposite to it.
  std::map<std::pair<int, int>, double> weights;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int apex = triangles(f, corner);
      const int a = triangles(f, (corner + 1) % 3);
      const int b = triangles(f, (corner + 2) % 3);
      weights[std::minmax(a, b)] += BoundedCotangent(
          points.row(apex), points.row(a), points.row(b), bound);
    }
  }
  for (auto& [edge, weight] : weights) {
    weight = std::max(weight, options.min_weight);
  }
  return weights;
}

// Returns l / (2 sqrt(a_i)) for each vertex.
Eigen::VectorXd RowScalesByArea(const Points& points,
                                const Triangles& triangles,
                                const CotangentLaplacianOptions& options) {
  const Eigen::VectorXd areas = VertexAreas(points, triangles);
  const double least =
      options.min_area * areas.sum() / std::max<Eigen::Index>(1, areas.size());
  return LengthScale(points, triangles, options) / 2 *
         areas.cwiseMax(least).cwiseSqrt().cwiseInverse();
}

}  // namespace

std::string ToString(LaplacianWeights weights) {
  switch (weights) {
    case LaplacianWeights::kArea:
      return "area";
    case LaplacianWeights::kPaper:
      return "paper";
  }
  LOG(FATAL) << "no such weights";
}

bool CotangentLaplacianOptions::IsValid(std::string* error) const {
  return OptionCheck("CotangentLaplacianOptions", error)
      .IsAtLeast("length_scale", length_scale, 0)
      .IsWithin("min_area", min_area, 1e-6, 1)
      .IsWithin("min_angle", min_angle, 1e-6, 1)
      .IsAbove("min_weight", min_weight, 0)
      .is_valid();
}

double LengthScale(const Points& points,
                   const Triangles& triangles,
                   const CotangentLaplacianOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  // Six equilateral triangles at each of N vertices: normalised rows are
  // h^2 / 4 laplace x with h^2 = 2 A / (sqrt(3) N), so that the sum of their
  // squares is A / (12 N) times the integral of |laplace x|^2.
  constexpr double kVerticesOfDefault = 200;
  constexpr double kEvenRows = 12;
  const bool is_paper = options.weights == LaplacianWeights::kPaper;
  if (!is_paper && options.length_scale > 0) return options.length_scale;
  const double vertices = is_paper ? points.rows() : kVerticesOfDefault;
  return std::sqrt(SurfaceArea(points, triangles) / (kEvenRows * vertices));
}

SparseMatrix CotangentLaplacian(const Points& points,
                                const Triangles& triangles,
                                const CotangentLaplacianOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const auto edge_weights = EdgeWeights(points, triangles, options);
  Eigen::VectorXd row_sums = Eigen::VectorXd::Zero(points.rows());
  for (const auto& [edge, weight] : edge_weights) {
    row_sums[edge.first] += weight;
    row_sums[edge.second] += weight;
  }
  const Eigen::VectorXd row_scales =
      options.weights == LaplacianWeights::kArea
          ? RowScalesByArea(points, triangles, options)
          : Eigen::VectorXd(row_sums.cwiseInverse());

  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(2 * edge_weights.size() + points.rows());
  for (const auto& [edge, weight] : edge_weights) {
    const auto [a, b] = edge;
    entries.emplace_back(a, b, weight * row_scales[a]);
    entries.emplace_back(b, a, weight * row_scales[b]);
  }
  for (int i = 0; i < points.rows(); ++i) {
    if (row_sums[i] > 0)
      entries.emplace_back(i, i, -row_sums[i] * row_scales[i]);
  }
  SparseMatrix laplacian(points.rows(), points.rows());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

}  // namespace musclewarp
