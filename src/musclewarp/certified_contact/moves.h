// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the distance (mm) by which all points but a share of them move at
// most from `a` to `b`, over all muscles. Where muscles are squeezed, single
// vertices never settle. `a`, `b`: #V x 3 each, mm, of the same muscles.
double MoveOfMost(const std::vector<Points>& a,
                  const std::vector<Points>& b,
                  double share);

// Returns the largest of these distances among the muscles, taken one by one.
double MoveOfMostMoved(const std::vector<Points>& a,
                       const std::vector<Points>& b,
                       double share);

}  // namespace musclewarp
