// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/box_grid.h"

#include <cmath>
#include <limits>

namespace musclewarp {
namespace {

// Sets an extent of a box to floats that enclose [lower, upper].
void SetExtent(double lower, double upper, int axis, RoundedBox* box) {
  // A float is off by 2^-24 of its size at most.
  constexpr float kRounding = 0x1p-22f;
  constexpr float kLeast = std::numeric_limits<float>::min();
  const auto low = static_cast<float>(lower);
  const auto high = static_cast<float>(upper);
  box->lower[axis] = low - (kRounding * std::abs(low) + kLeast);
  box->upper[axis] = high + (kRounding * std::abs(high) + kLeast);
}

}  // namespace

RoundedBox RoundedBox::GrownBy(double margin) const {
  RoundedBox grown;
  for (int k = 0; k < 3; ++k) {
    SetExtent(lower[k] - margin, upper[k] + margin, k, &grown);
  }
  return grown;
}

RoundedBox RoundedBoxOf(const Corners& triangle) {
  RoundedBox box;
  for (int k = 0; k < 3; ++k) {
    SetExtent(triangle.col(k).minCoeff(), triangle.col(k).maxCoeff(), k, &box);
  }
  return box;
}

RoundedBox RoundedBoxOf(const Eigen::RowVector3d& lower,
                        const Eigen::RowVector3d& upper) {
  RoundedBox box;
  for (int k = 0; k < 3; ++k) SetExtent(lower[k], upper[k], k, &box);
  return box;
}

BoxGrid::BoxGrid(const std::vector<RoundedBox>& boxes)
    : size_(static_cast<Eigen::Index>(boxes.size())) {
  if (boxes.empty()) return;
  Eigen::Array3d lower = Eigen::Array3d::Constant(1e30), upper = -lower;
  double size = 0;
  for (const RoundedBox& box : boxes) {
    double longest = 0;
    for (int k = 0; k < 3; ++k) {
      lower[k] = std::min<double>(lower[k], box.lower[k]);
      upper[k] = std::max<double>(upper[k], box.upper[k]);
      longest = std::max<double>(longest, box.upper[k] - box.lower[k]);
    }
    size += longest;
  }
  origin_ = lower;
  // Cells about as large as a box, and no more of them than four for each.
  cell_ = std::max(size / static_cast<double>(boxes.size()), 1e-9);
  const double most = 4.0 * static_cast<double>(boxes.size()) + 64;
  for (;; cell_ *= 1.3) {
    const Eigen::Array3d counts = ((upper - lower) / cell_).floor() + 1;
    if (counts.prod() > most) continue;
    for (int k = 0; k < 3; ++k) counts_[k] = static_cast<int>(counts[k]);
    break;
  }
  per_cell_ = 1 / cell_;
  starts_.assign(counts_[0] * counts_[1] * counts_[2] + 1, 0);
  for (const RoundedBox& box : boxes) {
    ForEachCell(box, [&](int cell, const Index3&) { ++starts_[cell + 1]; });
  }
  for (size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
  items_.resize(starts_.back());
  std::vector<int> next(starts_.begin(), starts_.end() - 1);
  for (size_t i = 0; i < boxes.size(); ++i) {
    const Index3 first = CellOf(boxes[i].lower);
    ForEachCell(boxes[i], [&](int cell, const Index3&) {
      items_[next[cell]++] = {boxes[i], static_cast<int>(i), first};
    });
  }
}

bool BoxGrid::OverlapsAny(const RoundedBox& box) const {
  if (size_ == 0) return false;
  bool overlaps = false;
  ForEachCell(box, [&](int cell, const Index3&) {
    for (int i = starts_[cell]; i < starts_[cell + 1] && !overlaps; ++i) {
      overlaps = box.Overlaps(items_[i].box);
    }
  });
  return overlaps;
}

}  // namespace musclewarp
