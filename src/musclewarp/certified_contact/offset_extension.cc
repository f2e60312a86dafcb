// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/offset_extension.h"

#include <glog/logging.h>

namespace musclewarp {

OffsetExtension::OffsetExtension(const MuscleSurface& surface,
                                 const std::vector<int>& given,
                                 double length)
    : given_(given) {
  CHECK_GT(length, 0);
  const int count = surface.num_vertices();
  // The index of each vertex among the free ones; given vertices are numbered
  // from `count` on.
  std::vector<int> place(count, 0);
  for (size_t i = 0; i < given.size(); ++i) {
    place[given[i]] = count + static_cast<int>(i);
  }
  for (int v = 0; v < count; ++v) {
    if (place[v] >= count) continue;
    place[v] = static_cast<int>(free_.size());
    free_.push_back(v);
  }
  std::vector<Eigen::Triplet<double>> matrix, coupling;
  for (size_t i = 0; i < free_.size(); ++i) {
    const int v = free_[i];
    const int row = static_cast<int>(i);
    double diagonal = surface.areas[v] / (length * length);
    for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
      const double weight = surface.weights[e];
      const int column = place[surface.neighbours[e]];
      diagonal += weight;
      if (column >= count) {
        coupling.emplace_back(row, column - count, weight);
      } else {
        matrix.emplace_back(row, column, -weight);
      }
    }
    matrix.emplace_back(row, row, diagonal);
  }
  const auto size = static_cast<Eigen::Index>(free_.size());
  Eigen::SparseMatrix<double> system(size, size);
  system.setFromTriplets(matrix.begin(), matrix.end());
  coupling_.resize(size, static_cast<Eigen::Index>(given.size()));
  coupling_.setFromTriplets(coupling.begin(), coupling.end());
  factor_.compute(system);
  CHECK(factor_.info() == Eigen::Success);
}

Points OffsetExtension::Extended(const Points& given) const {
  Points offsets(given_.size() + free_.size(), 3);
  for (size_t i = 0; i < given_.size(); ++i) {
    offsets.row(given_[i]) = given.row(i);
  }
  const Points solved = factor_.solve(Eigen::MatrixXd(coupling_ * given));
  for (size_t i = 0; i < free_.size(); ++i) {
    offsets.row(free_[i]) = solved.row(i);
  }
  return offsets;
}

}  // namespace musclewarp
