// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/box_grid.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The triangles of a mesh in groups of neighbours, so that most of a mesh that
// is far from another is ruled out by the boxes of groups. They are made once,
// from any pose of the mesh: where its vertices are later makes a search faster
// or slower and never changes what it finds, as the boxes are those of the
// present vertices.
class TriangleClusters {
 public:
  // `points`: #V x 3, in which triangles are near each other; `triangles`: #F
  // x 3. There may be none.
  TriangleClusters(const Points& points, const Triangles& triangles);

  int size() const { return static_cast<int>(triangle_starts_.size()) - 1; }
  Eigen::Index num_triangles() const { return triangles_.size(); }

  // The numbers of the triangles of cluster c, ascending. Every triangle is in
  // one cluster.
  const int* begin(int c) const {
    return triangles_.data() + triangle_starts_[c];
  }
  const int* end(int c) const {
    return triangles_.data() + triangle_starts_[c + 1];
  }

  // Returns a box around the triangles of each cluster, their vertices being at
  // `points` (#V x 3, mm).
  std::vector<RoundedBox> BoxesAt(const Points& points) const;

 private:
  std::vector<int> triangles_, triangle_starts_ = {0};
  std::vector<int> vertices_, vertex_starts_ = {0};  // those of the clusters
};

}  // namespace musclewarp
