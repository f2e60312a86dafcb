// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/triangle_clusters.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "musclewarp/proximity/triangle_halves.h"

namespace musclewarp {
namespace {

// The largest number of triangles in a cluster.
constexpr std::ptrdiff_t kLargest = 16;

// Calls visit(begin, end) for parts of [begin, end) of at most kLargest
// triangles, by halves.
template <typename Visit>
void Split(const Points& centroids, int* begin, int* end, const Visit& visit) {
  if (end - begin <= kLargest) return visit(begin, end);
  int* const middle = begin + (end - begin) / 2;
  SplitAlongLongestSide(centroids, begin, middle, end);
  Split(centroids, begin, middle, visit);
  Split(centroids, middle, end, visit);
}

}  // namespace

TriangleClusters::TriangleClusters(const Points& points,
                                   const Triangles& triangles)
    : triangles_(triangles.rows()) {
  if (triangles_.empty()) return;
  const Points centroids = CentroidsOf(points, triangles);
  std::iota(triangles_.begin(), triangles_.end(), 0);
  int* const first = triangles_.data();
  Split(centroids, first, first + triangles_.size(), [&](int* begin, int* end) {
    std::sort(begin, end);
    triangle_starts_.push_back(static_cast<int>(end - first));
    std::vector<int> vertices;
    for (const int* f = begin; f < end; ++f) {
      for (const int v : triangles.row(*f)) vertices.push_back(v);
    }
    std::sort(vertices.begin(), vertices.end());
    std::unique_copy(
        vertices.begin(), vertices.end(), std::back_inserter(vertices_));
    vertex_starts_.push_back(static_cast<int>(vertices_.size()));
  });
}

std::vector<RoundedBox> TriangleClusters::BoxesAt(const Points& points) const {
  std::vector<RoundedBox> boxes(size());
#pragma omp parallel for schedule(static)
  for (int c = 0; c < size(); ++c) {
    const int* const begin = vertices_.data() + vertex_starts_[c];
    const int* const end = vertices_.data() + vertex_starts_[c + 1];
    Eigen::RowVector3d lower = points.row(*begin), upper = lower;
    for (const int* v = begin; v < end; ++v) {
      lower = lower.cwiseMin(points.row(*v));
      upper = upper.cwiseMax(points.row(*v));
    }
    boxes[c] = RoundedBoxOf(lower, upper);
  }
  return boxes;
}

}  // namespace musclewarp
