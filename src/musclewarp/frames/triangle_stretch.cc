// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/triangle_stretch.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
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

Eigen::VectorXd TriangleAreas(const Points& points,
                              const Triangles& triangles) {
  Eigen::VectorXd areas(triangles.rows());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    areas[f] = AreaVector(CornersOf(points, triangles.row(f))).norm() / 2;
  }
  return areas;
}

// The patches of a surface, in the order of their labels.
struct Patches {
  Eigen::VectorXd areas;  // mm^2
  Points centres;         // #patches x 3, mm
};

// Returns the connected parts that the triangles of a surface in `chosen` make
// up. `areas`: #F, of all triangles.
Patches PatchesOf(const std::vector<Eigen::Index>& chosen,
                  const Eigen::VectorXd& areas,
                  const Points& deformed,
                  const Triangles& triangles) {
  const Triangles parts = triangles(chosen, Eigen::all);
  const Components components =
      ConnectedComponents(parts, EdgeUses(parts), chosen.size());
  Patches patches = {Eigen::VectorXd::Zero(components.count),
                     Points::Zero(components.count, 3)};
  for (size_t i = 0; i < chosen.size(); ++i) {
    const double area = areas[chosen[i]];
    patches.areas[components.label[i]] += area;
    patches.centres.row(components.label[i]) +=
        area * CornersOf(deformed, parts.row(i)).colwise().mean();
  }
  for (Eigen::Index i = 0; i < patches.areas.size(); ++i) {
    patches.centres.row(i) /= patches.areas[i];
  }
  return patches;
}

// Returns the largest of them; no area if there is none.
SurfacePatch LargestOf(const Patches& patches) {
  if (patches.areas.size() == 0) return {};
  Eigen::Index largest;
  const double area = patches.areas.maxCoeff(&largest);
  return {area, patches.centres.row(largest)};
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
  const Patches patches = PatchesOf(beyond, areas, deformed, triangles);
  const SurfacePatch largest = LargestOf(patches);
  measures->area_of_patches = patches.areas.sum();
  measures->largest_patch = largest.area;
  measures->patch_place = largest.place;
}

}  // namespace

double AspectOf(const Corners& t) {
  double longest = 0;  // squared
  for (int k = 0; k < 3; ++k) {
    longest = std::max(longest, (t.row((k + 1) % 3) - t.row(k)).squaredNorm());
  }
  return longest > 0 ? AreaVector(t).norm() / longest : 0;
}

double StretchOf(const Corners& rest, const Corners& deformed) {
  if (!(AspectOf(rest) >= kSliverAspect)) return 1;
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

SurfacePatch LargestTornPatch(const Points& rest,
                              const Points& deformed,
                              const Points& without_contact,
                              const Triangles& triangles) {
  const Eigen::VectorXd stretches =
      TriangleStretches(rest, deformed, triangles);
  const Eigen::VectorXd free =
      TriangleStretches(rest, without_contact, triangles);
  std::vector<Eigen::Index> torn;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    if (stretches[f] >
        std::max(kStretchOfPatches, free[f] + kStretchByContact)) {
      torn.push_back(f);
    }
  }
  return LargestOf(
      PatchesOf(torn, TriangleAreas(rest, triangles), deformed, triangles));
}

std::vector<double> WeightedQuantiles(const Eigen::VectorXd& values,
                                      const Eigen::VectorXd& weights,
                                      const std::vector<double>& fractions) {
  CHECK_GT(values.size(), 0);
  CHECK_EQ(values.size(), weights.size());
  using Weighted = std::pair<double, double>;  // value, weight
  std::vector<Weighted> all(values.size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = {values[i], weights[i]};
  const double whole = weights.sum();
  std::vector<double> quantiles;
  // What is before `begin` does not exceed the last quantile, and weighs
  // `before`.
  auto begin = all.begin();
  double before = 0;
  for (const double fraction : fractions) {
    // The quantile is in [begin, end), which is halved until it is alone.
    auto end = all.end();
    while (end - begin > 1) {
      const auto middle = begin + (end - begin) / 2;
      std::nth_element(begin, middle, end);
      const double lower = std::accumulate(
          begin, middle, before, [](double sum, const Weighted& weighted) {
            return sum + weighted.second;
          });
      if (lower >= fraction * whole) {
        end = middle;
      } else {
        begin = middle;
        before = lower;
      }
    }
    quantiles.push_back(begin->first);
  }
  return quantiles;
}

}  // namespace musclewarp
