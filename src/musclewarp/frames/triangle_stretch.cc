// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/triangle_stretch.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/triangle.h"

namespace musclewarp {
namespace {

// The metric of a triangle in the coordinates of its first two edges.
Eigen::Matrix2d MetricOf(const Corners& t) {
  Eigen::Matrix<double, 2, 3> edges;
  edges << t.row(1) - t.row(0), t.row(2) - t.row(0);
  return edges * edges.transpose();
}

bool IsSliver(const Corners& t) {
  double longest = 0;  // squared
  for (int k = 0; k < 3; ++k) {
    longest = std::max(longest, (t.row((k + 1) % 3) - t.row(k)).squaredNorm());
  }
  return !(AreaVector(t).norm() >= kSliverAspect * longest) || longest == 0;
}

Eigen::VectorXd TriangleAreas(const Points& points,
                              const Triangles& triangles) {
  Eigen::VectorXd areas(triangles.rows());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    areas[f] = AreaVector(CornersOf(points, triangles.row(f))).norm() / 2;
  }
  return areas;
}

void MeasurePatches(const Eigen::VectorXd& stretches,
                    const Eigen::VectorXd& areas,
                    const Points& deformed,
                    const Triangles& triangles,
                    StretchMeasures* measures) {
  std::vector<Eigen::Index> beyond;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    if (stretches[f] > kStretchOfPatches) beyond.push_back(f);
  }
  if (beyond.empty()) return;
  const Triangles torn = triangles(beyond, Eigen::all);
  const Components patches =
      ConnectedComponents(torn, EdgeUses(torn), beyond.size());
  Eigen::VectorXd area_of = Eigen::VectorXd::Zero(patches.count);
  Points centre_of = Points::Zero(patches.count, 3);  // times the area
  for (size_t i = 0; i < beyond.size(); ++i) {
    const double area = areas[beyond[i]];
    area_of[patches.label[i]] += area;
    centre_of.row(patches.label[i]) +=
        area * CornersOf(deformed, torn.row(i)).colwise().mean();
  }
  Eigen::Index largest;
  measures->area_of_patches = area_of.sum();
  measures->largest_patch = area_of.maxCoeff(&largest);
  measures->patch_place = centre_of.row(largest) / area_of[largest];
}

}  // namespace

double StretchOf(const Corners& rest, const Corners& deformed) {
  if (IsSliver(rest)) return 1;
  // The stretches are the roots of the eigenvalues of the metric after the
  // deformation relative to that at rest.
  const Eigen::Matrix2d ratio = MetricOf(rest).inverse() * MetricOf(deformed);
  const double half_trace = ratio.trace() / 2;
  const double root =
      std::sqrt(std::max(0.0, half_trace * half_trace - ratio.determinant()));
  return std::sqrt(std::max(0.0, half_trace + root));
}

Eigen::VectorXd TriangleStretches(const Points& rest,
                                  const Points& deformed,
                                  const Triangles& triangles) {
  Eigen::VectorXd stretches(triangles.rows());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    stretches[f] = StretchOf(CornersOf(rest, triangles.row(f)),
                             CornersOf(deformed, triangles.row(f)));
  }
  return stretches;
}

StretchMeasures MeasureStretch(const Points& rest,
                               const Points& deformed,
                               const Triangles& triangles) {
  const Eigen::VectorXd stretches =
      TriangleStretches(rest, deformed, triangles);
  const Eigen::VectorXd areas = TriangleAreas(rest, triangles);
  StretchMeasures measures;
  measures.mean = stretches.dot(areas) / areas.sum();
  const std::vector<double> quantiles =
      WeightedQuantiles(stretches, areas, {0.99, 0.999});
  measures.quantile_99 = quantiles[0];
  measures.quantile_999 = quantiles[1];
  Eigen::Index where;
  measures.largest = stretches.maxCoeff(&where);
  measures.largest_place =
      CornersOf(deformed, triangles.row(where)).colwise().mean();
  measures.area_beyond_anatomy =
      (stretches.array() > kStretchBeyondAnatomy).select(areas, 0).sum();
  MeasurePatches(stretches, areas, deformed, triangles, &measures);
  return measures;
}

std::vector<double> WeightedQuantiles(const Eigen::VectorXd& values,
                                      const Eigen::VectorXd& weights,
                                      const std::vector<double>& fractions) {
  CHECK_GT(values.size(), 0);
  CHECK_EQ(values.size(), weights.size());
  std::vector<Eigen::Index> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return values[a] < values[b];
  });
  const double whole = weights.sum();
  std::vector<double> quantiles;
  size_t i = 0;
  double sum = weights[order[0]];
  for (const double fraction : fractions) {
    while (sum < fraction * whole && i + 1 < order.size()) {
      sum += weights[order[++i]];
    }
    quantiles.push_back(values[order[i]]);
  }
  return quantiles;
}

}  // namespace musclewarp
