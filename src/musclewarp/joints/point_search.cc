// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/point_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

namespace musclewarp {
namespace {

// The result set of a nanoflann query. The result sets of the library have
// different names in different versions, but the same interface.
template <typename Index>
class WithinRadius {
 public:
  WithinRadius(double squared_radius, std::vector<int>* found)
      : squared_radius_(squared_radius), found_(found) {}

  bool addPoint(double squared_distance, Index point) {
    if (squared_distance <= squared_radius_) {
      found_->push_back(static_cast<int>(point));
    }
    return true;
  }
  // Nodes are entered up to this distance, which is not one of them.
  double worstDist() const {
    return std::nextafter(squared_radius_,
                          std::numeric_limits<double>::infinity());
  }
  bool full() const { return true; }
  size_t size() const { return found_->size(); }
  bool empty() const { return found_->empty(); }
  void sort() {}

 private:
  double squared_radius_;
  std::vector<int>* found_;
};

}  // namespace

struct PointSearch::Tree {
  // Points in the form that nanoflann takes them.
  struct List {
    const Points& points;

    size_t kdtree_get_point_count() const { return points.rows(); }
    double kdtree_get_pt(size_t point, size_t axis) const {
      return points(point, axis);
    }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };

  explicit Tree(const Points& points)
      : list{points}, index(3, list, {/*leaf_max_size=*/16}) {}

  List list;
  nanoflann::KDTreeSingleIndexAdaptor<
      nanoflann::L2_Simple_Adaptor<double, List>,
      List,
      3,
      unsigned>
      index;
};

PointSearch::PointSearch(const Points& points)
    : tree_(std::make_unique<Tree>(points)) {}
PointSearch::~PointSearch() = default;
PointSearch::PointSearch(PointSearch&&) noexcept = default;

std::vector<int> PointSearch::Within(const Eigen::Vector3d& place,
                                     double radius) const {
  std::vector<int> within;
  if (tree_->list.points.rows() == 0) return within;
  WithinRadius<unsigned> found(radius * radius, &within);
  tree_->index.findNeighbors(found, place.data(), {});
  std::sort(within.begin(), within.end());
  return within;
}

int PointSearch::Nearest(const Eigen::Vector3d& place) const {
  if (tree_->list.points.rows() == 0) return -1;
  unsigned nearest = 0;
  double squared_distance = 0;
  tree_->index.knnSearch(place.data(), 1, &nearest, &squared_distance);
  return static_cast<int>(nearest);
}

}  // namespace musclewarp
