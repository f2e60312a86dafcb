// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/contact_samples.h"

#include <set>

#include "musclewarp/geometry/spread_points.h"
#include "musclewarp/mesh/triangle.h"

namespace musclewarp {
namespace {

// Returns a lattice of points over each triangle, four steps to an edge.
Points LatticeOver(const TriangleSoup& mesh) {
  constexpr int kSteps = 4;
  constexpr int kPointsOfTriangle = (kSteps + 1) * (kSteps + 2) / 2;
  Points lattice(kPointsOfTriangle * mesh.triangles.rows(), 3);
  Eigen::Index next = 0;
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    const Corners t = CornersOf(mesh.points, mesh.triangles.row(f));
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        lattice.row(next++) =
            (i * t.row(0) + j * t.row(1) + (kSteps - i - j) * t.row(2)) /
            kSteps;
      }
    }
  }
  return lattice;
}

}  // namespace

std::vector<int> ContactSamples(const Points& fine,
                                const TriangleSoup& hull,
                                int count) {
  const Points lattice = LatticeOver(hull);
  std::set<int> samples;
  for (const int place : SpreadPoints(lattice, count)) {
    Eigen::Index nearest;
    (fine.rowwise() - lattice.row(place))
        .rowwise()
        .squaredNorm()
        .minCoeff(&nearest);
    samples.insert(static_cast<int>(nearest));
  }
  return {samples.begin(), samples.end()};
}

}  // namespace musclewarp
