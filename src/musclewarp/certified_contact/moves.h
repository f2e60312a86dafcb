// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the largest distance (mm) between corresponding points of `a` and
// `b`, over all muscles, without the fraction `share` of points that move
// farthest: in squeezed muscles, single vertices never converge. `a`, `b`: #V x
// 3 each, mm.
double MoveOfMost(const std::vector<Points>& a,
                  const std::vector<Points>& b,
                  double share);

// Returns the maximum over the muscles of that distance, measured per muscle.
double MoveOfMostMoved(const std::vector<Points>& a,
                       const std::vector<Points>& b,
                       double share);

}  // namespace musclewarp
