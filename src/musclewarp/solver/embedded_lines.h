// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Polylines in or near a muscle, such as muscle fibres, that move with it. Each
// point is expressed in mean value coordinates (Ju et al. 2005) of the coarse
// hull, exactly as the fine vertices are, so that lines and surface deform
// alike:
//
//   const EmbeddedLines lines = EmbedLines(fibres, hull.points,
//   hull.triangles); for (each frame) Draw(LinesAt(lines, coarse));
struct EmbeddedLines {
  // One row per point of all lines, #points x N. Each row sums to 1.
  RowMajorMatrix from_coarse;

  // Line k has the rows from starts[k] to starts[k + 1], exclusive.
  std::vector<int> starts = {0};

  int num_lines() const { return static_cast<int>(starts.size()) - 1; }
};

// Ties the polylines `rest` (each #P x 3, rest pose, mm) to the hull with the
// rest vertices `coarse_rest` (N x 3, mm). The hull must be closed.
EmbeddedLines EmbedLines(const std::vector<Points>& rest,
                         const Points& coarse_rest,
                         const Triangles& coarse_triangles);

// Returns the polylines for the hull vertices `coarse` (N x 3, mm), in the
// order and with the numbers of points that EmbedLines was given.
std::vector<Points> LinesAt(const EmbeddedLines& lines, const Points& coarse);

}  // namespace musclewarp
