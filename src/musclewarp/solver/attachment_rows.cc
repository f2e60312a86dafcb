// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/attachment_rows.h"

namespace musclewarp {

std::vector<int> AttachedVertices(const Attachment& attachment,
                                  const Points& points,
                                  int max_rows) {
  std::vector<int> near;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const double squared = (attachment.points.rowwise() - points.row(v))
                               .rowwise()
                               .squaredNorm()
                               .minCoeff();
    if (squared <= attachment.radius * attachment.radius) near.push_back(v);
  }
  if (static_cast<int>(near.size()) <= max_rows) return near;
  std::vector<int> thinned(max_rows);
  for (int i = 0; i < max_rows; ++i) {
    thinned[i] = near[i * near.size() / max_rows];
  }
  return thinned;
}

}  // namespace musclewarp
