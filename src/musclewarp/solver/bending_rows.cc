// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bending_rows.h"

#include <glog/logging.h>

#include <cmath>

#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {

BendingRows MakeBendingRows(const std::vector<Points>& fibres,
                            const Points& coarse_rest,
                            const Triangles& coarse_triangles,
                            double stiffness) {
  BendingRows rows;
  std::vector<double> spacings;  // of each row
  Eigen::Index count = 0;
  for (const Points& fibre : fibres) {
    const double length = PolylineLength(fibre);
    if (fibre.rows() < 3 || !(length > 0)) continue;
    rows.rest.conservativeResize(count + fibre.rows(), 3);
    rows.rest.bottomRows(fibre.rows()) = fibre;
    for (Eigen::Index k = 1; k + 1 < fibre.rows(); ++k) {
      rows.points.push_back(static_cast<int>(count + k));
      spacings.push_back(length / (fibre.rows() - 1));
    }
    count += fibre.rows();
  }
  const Eigen::Index num_rows = rows.points.size();
  rows.from_coarse.resize(num_rows, coarse_rest.rows());
  rows.weights.resize(num_rows);
  if (num_rows == 0) return rows;
  const RowMajorMatrix from_coarse =
      MeanValueCoordinates(rows.rest, coarse_rest, coarse_triangles);
  for (Eigen::Index i = 0; i < num_rows; ++i) {
    const int k = rows.points[i];
    rows.weights[i] =
        stiffness / std::sqrt(num_rows) / (spacings[i] * spacings[i]);
    rows.from_coarse.row(i) =
        rows.weights[i] * (from_coarse.row(k - 1) - 2 * from_coarse.row(k) +
                           from_coarse.row(k + 1));
  }
  return rows;
}

Points BendingTargets(const BendingRows& rows,
                      const std::vector<Eigen::Matrix3d>& rotations,
                      const Eigen::VectorXd& stretches) {
  Points targets(rows.points.size(), 3);
  for (size_t i = 0; i < rows.points.size(); ++i) {
    const int k = rows.points[i];
    // The stretch of an edge is the mean of those of its ends.
    const double before = (stretches[k - 1] + stretches[k]) / 2;
    const double after = (stretches[k] + stretches[k + 1]) / 2;
    const Eigen::RowVector3d bend =
        after * (rows.rest.row(k + 1) - rows.rest.row(k)) -
        before * (rows.rest.row(k) - rows.rest.row(k - 1));
    targets.row(i) = rows.weights[i] * bend * rotations[k].transpose();
  }
  return targets;
}

}  // namespace musclewarp
