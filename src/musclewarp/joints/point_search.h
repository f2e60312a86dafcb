// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A tree over points that finds those near a place. Queries are const and may
// run on many threads.
class PointSearch {
 public:
  // Builds the tree; `points` (#P x 3, mm) must live as long as the tree.
  explicit PointSearch(const Points& points);
  ~PointSearch();
  PointSearch(PointSearch&&) noexcept;

  // Returns the indices of the points at most `radius` (mm) away, in ascending
  // order.
  std::vector<int> Within(const Eigen::Vector3d& place, double radius) const;

  // Returns the index of the nearest point, or -1 if there are no points.
  int Nearest(const Eigen::Vector3d& place) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace musclewarp
