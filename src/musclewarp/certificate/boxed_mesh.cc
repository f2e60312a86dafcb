// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/boxed_mesh.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>

namespace musclewarp {

BoxedMesh::BoxedMesh(const SurfaceView& view) : view_(view) {
  if (!view.clusters) own_clusters_.emplace(*view.points, *view.triangles);
  CHECK_EQ(clusters().num_triangles(), num_triangles());
  boxes_ = clusters().BoxesAt(*view.points);
  constexpr float kLargest = std::numeric_limits<float>::max();
  box_.lower.fill(kLargest);
  box_.upper.fill(-kLargest);
  for (const RoundedBox& box : boxes_) {
    for (int k = 0; k < 3; ++k) {
      box_.lower[k] = std::min(box_.lower[k], box.lower[k]);
      box_.upper[k] = std::max(box_.upper[k], box.upper[k]);
    }
  }
}

}  // namespace musclewarp
