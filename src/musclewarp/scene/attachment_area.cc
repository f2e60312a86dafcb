// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/attachment_area.h"

namespace musclewarp {

std::vector<int> VerticesInArea(const Attachment& attachment,
                                const Points& points) {
  std::vector<int> inside;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const double squared = (attachment.points.rowwise() - points.row(v))
                               .rowwise()
                               .squaredNorm()
                               .minCoeff();
    if (squared <= attachment.radius * attachment.radius) inside.push_back(v);
  }
  return inside;
}

}  // namespace musclewarp
