// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Polylines in or near a muscle that move with it as its fine vertices do, by
// mean value coordinates in the coarse hull.
struct CarriedLines {
  RowMajorMatrix from_coarse;     // #points x N
  std::vector<int> starts = {0};  // line k is rows starts[k] to starts[k + 1]

  int num_lines() const { return static_cast<int>(starts.size()) - 1; }
};

// `rest`: polylines in the rest pose, each #P x 3, mm.
CarriedLines CarryLines(const std::vector<Points>& rest,
                        const Points& coarse_rest,
                        const Triangles& coarse_triangles);

// Where the coarse vertices (N x 3) take them.
std::vector<Points> LinesAt(const CarriedLines& lines, const Points& coarse);

}  // namespace musclewarp
