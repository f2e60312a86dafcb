// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Divides the fibres of a muscle (#P x 3 each, mm, from origin to insertion)
// into at most `count` bands of fibres that run close to each other (k-means
// over ten points of each, from a start that nothing random decides). Returns
// the numbers of the fibres of each band, ascending; the band of the first
// fibre comes first. There are fewer bands if there are fewer fibres.
std::vector<std::vector<int>> FibreBands(const std::vector<Points>& fibres,
                                         int count);

}  // namespace musclewarp
