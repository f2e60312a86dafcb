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

// Returns the mean of the fibres of a band, given by their numbers: ten points.
// Precondition (CHECKed): there is a fibre, and all are there.
Points MeanFibre(const std::vector<Points>& fibres,
                 const std::vector<int>& band);

// Returns the number of the line (#P x 3 each, mm) that runs closest to a band,
// given by the numbers of its fibres: over ten points of each, to MeanFibre().
// Precondition (CHECKed): there is a line and a fibre.
int NearestLine(const std::vector<Points>& fibres,
                const std::vector<int>& band,
                const std::vector<Points>& lines);

}  // namespace musclewarp
