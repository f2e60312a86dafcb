// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/certificate/box_grid.h"
#include "musclewarp/certificate/surface_view.h"
#include "musclewarp/certificate/triangle_clusters.h"
#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// A mesh at its current place with a box around each cluster of triangles, so
// that the boxes are computed once for several searches. Keeps the pointers of
// the view, whose clusters it uses or, without any, makes.
class BoxedMesh {
 public:
  explicit BoxedMesh(const SurfaceView& view);

  const SurfaceView& view() const { return view_; }
  Eigen::Index num_triangles() const { return view_.triangles->rows(); }
  Corners corners(Eigen::Index triangle) const {
    return CornersOf(*view_.points, view_.triangles->row(triangle));
  }

  const TriangleClusters& clusters() const {
    return view_.clusters ? *view_.clusters : *own_clusters_;
  }
  const std::vector<RoundedBox>& cluster_boxes() const { return boxes_; }

  // A box around all triangles, which is empty (overlaps nothing) if there are
  // none.
  const RoundedBox& box() const { return box_; }

 private:
  SurfaceView view_;
  std::optional<TriangleClusters> own_clusters_;
  std::vector<RoundedBox> boxes_;
  RoundedBox box_;
};

}  // namespace musclewarp
