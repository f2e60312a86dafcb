// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/attachment_rows.h"

#include "musclewarp/scene/attachment_area.h"

namespace musclewarp {

std::vector<int> VerticesWithRows(const Attachment& attachment,
                                  const Points& points,
                                  int max_rows) {
  const std::vector<int> near = VerticesInArea(attachment, points);
  if (static_cast<int>(near.size()) <= max_rows) return near;
  std::vector<int> thinned(max_rows);
  for (int i = 0; i < max_rows; ++i) {
    thinned[i] = near[i * near.size() / max_rows];
  }
  return thinned;
}

}  // namespace musclewarp
