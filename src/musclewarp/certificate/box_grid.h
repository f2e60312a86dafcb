// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// A closed box with faces parallel to the axes (mm), in single precision and
// rounded outward: it is never smaller than what it was made for, so that a
// search by boxes misses nothing. It needs half the memory of a Box3.
struct RoundedBox {
  std::array<float, 3> lower, upper;

  // True if the boxes share a point, be it only on their boundaries.
  bool Overlaps(const RoundedBox& other) const {
    return lower[0] <= other.upper[0] && other.lower[0] <= upper[0] &&
           lower[1] <= other.upper[1] && other.lower[1] <= upper[1] &&
           lower[2] <= other.upper[2] && other.lower[2] <= upper[2];
  }

  // Returns this box, grown by `margin` (mm) on all sides.
  RoundedBox GrownBy(double margin) const;
};

// Returns a box that contains a triangle, or all points between two corners.
RoundedBox RoundedBoxOf(const Corners& triangle);
RoundedBox RoundedBoxOf(const Eigen::RowVector3d& lower,
                        const Eigen::RowVector3d& upper);

// A uniform grid over boxes, which finds those that overlap another box without
// looking at all of them. The certificate searches with it, where contact
// searches trees. Memory and the time to build the grid are proportional to the
// number of boxes. Queries are const and may run on many threads.
//
//   const BoxGrid grid(boxes);
//   grid.ForEachOverlap(box, grid.size(), [&](int i) { Test(boxes[i]); });
class BoxGrid {
 public:
  // Sorts the boxes into cells about as large as they are. They are copied, and
  // there may be none.
  explicit BoxGrid(const std::vector<RoundedBox>& boxes);

  // The number of boxes.
  Eigen::Index size() const { return size_; }

  // Calls visit(i) for those of the first `count` boxes that overlap `box`, for
  // each once, in no particular order.
  template <typename Visit>
  void ForEachOverlap(const RoundedBox& box,
                      Eigen::Index count,
                      const Visit& visit) const;

  // Returns true if there is a box that overlaps `box`.
  bool OverlapsAny(const RoundedBox& box) const;

 private:
  using Index3 = std::array<int, 3>;

  struct Item {
    RoundedBox box;
    int index;
    Index3 first;  // of the cells that it touches
  };

  Index3 CellOf(const std::array<float, 3>& p) const;

  // Calls visit(cell, at) for the cells that a box touches, `at` being their
  // places along x, y and z: for none if the box is beside the grid.
  template <typename Visit>
  void ForEachCell(const RoundedBox& box, const Visit& visit) const;

  Eigen::Index size_ = 0;
  Eigen::Array3d origin_ = Eigen::Array3d::Zero();
  double cell_ = 1, per_cell_ = 1;  // edge, mm, and its inverse
  Index3 counts_ = {1, 1, 1};       // of cells along x, y and z
  // The items of cell c are items_[starts_[c]] to items_[starts_[c + 1]], in
  // ascending order.
  std::vector<int> starts_;
  std::vector<Item> items_;
};

inline BoxGrid::Index3 BoxGrid::CellOf(const std::array<float, 3>& p) const {
  Index3 at;
  for (int k = 0; k < 3; ++k) {
    const double cell = (p[k] - origin_[k]) * per_cell_;
    at[k] = static_cast<int>(std::clamp(cell, 0.0, counts_[k] - 1.0));
  }
  return at;
}

template <typename Visit>
void BoxGrid::ForEachCell(const RoundedBox& box, const Visit& visit) const {
  for (int k = 0; k < 3; ++k) {
    if (box.upper[k] < origin_[k] ||
        box.lower[k] > origin_[k] + cell_ * counts_[k]) {
      return;
    }
  }
  const Index3 first = CellOf(box.lower), last = CellOf(box.upper);
  for (int z = first[2]; z <= last[2]; ++z) {
    for (int y = first[1]; y <= last[1]; ++y) {
      for (int x = first[0]; x <= last[0]; ++x) {
        visit((z * counts_[1] + y) * counts_[0] + x, Index3{x, y, z});
      }
    }
  }
}

template <typename Visit>
void BoxGrid::ForEachOverlap(const RoundedBox& box,
                             Eigen::Index count,
                             const Visit& visit) const {
  if (size_ == 0) return;
  const Index3 first = CellOf(box.lower);
  ForEachCell(box, [&](int cell, const Index3& at) {
    for (int i = starts_[cell]; i < starts_[cell + 1]; ++i) {
      if (items_[i].index >= count) break;  // they ascend in a cell
      if (!box.Overlaps(items_[i].box)) continue;
      // Of the cells that both touch, in the first one only.
      bool is_first = true;
      for (int k = 0; k < 3; ++k) {
        is_first &= at[k] == std::max(first[k], items_[i].first[k]);
      }
      if (is_first) visit(items_[i].index);
    }
  });
}

}  // namespace musclewarp
