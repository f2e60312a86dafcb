// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns, by muscle, the largest distance (mm) between corresponding points of
// `a` and `b` without the fraction `share` of points that move farthest: in
// squeezed muscles, single vertices never converge. `a`, `b`: #V x 3 each, mm.
std::vector<double> MovesOfMost(const std::vector<Points>& a,
                                const std::vector<Points>& b,
                                double share);

// Returns the maximum over the muscles of that distance, or 0 without muscles.
double MoveOfMostMoved(const std::vector<Points>& a,
                       const std::vector<Points>& b,
                       double share);

}  // namespace musclewarp
