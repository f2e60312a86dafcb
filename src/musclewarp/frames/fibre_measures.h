// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What tells whether the fibres of a muscle are spread through it: each fibre
// is a polyline from the origin to the insertion, #P x 3, mm.
struct FibreSpread {
  double shortest = 0;  // length, mm

  // The root mean square distances of their ends from the mean of these, mm.
  double at_origin = 0;
  double at_insertion = 0;
};

// Returns the spread of fibres; zeros without any.
FibreSpread SpreadOf(const std::vector<Points>& fibres);

// Returns by which factor each fifth of the length, from the origin on, is
// longer than at rest: the mean over the fibres. `rest` and `fibres` are the
// same fibres, of which every fifth counts by its length at rest. 1 without
// any.
std::array<double, 5> StretchByFifths(const std::vector<Points>& rest,
                                      const std::vector<Points>& fibres);

}  // namespace musclewarp
