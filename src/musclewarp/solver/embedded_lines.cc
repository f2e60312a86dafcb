// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/embedded_lines.h"

namespace musclewarp {

EmbeddedLines EmbedLines(const std::vector<Points>& rest,
                         const Points& coarse_rest,
                         const Triangles& coarse_triangles) {
  EmbeddedLines lines;
  for (const Points& line : rest) {
    lines.starts.push_back(lines.starts.back() + static_cast<int>(line.rows()));
  }
  Points all(lines.starts.back(), 3);
  for (size_t k = 0; k < rest.size(); ++k) {
    all.middleRows(lines.starts[k], rest[k].rows()) = rest[k];
  }
  lines.from_coarse = MeanValueCoordinates(all, coarse_rest, coarse_triangles);
  return lines;
}

std::vector<Points> LinesAt(const EmbeddedLines& lines, const Points& coarse) {
  // Without lines the coordinates may never have been made.
  if (lines.num_lines() == 0) return {};
  const Points all = lines.from_coarse * coarse;
  std::vector<Points> moved;
  for (int k = 0; k < lines.num_lines(); ++k) {
    moved.push_back(
        all.middleRows(lines.starts[k], lines.starts[k + 1] - lines.starts[k]));
  }
  return moved;
}

}  // namespace musclewarp
