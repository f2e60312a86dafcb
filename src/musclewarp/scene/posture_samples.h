// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace musclewarp {

// Samples of the unit cube for designs of postures: one row for each sample,
// one column for each coordinate, values from 0 to 1. They are the same on
// every machine.

// Returns a Latin hypercube: each coordinate is divided into `count` intervals
// of equal length, and every interval has one sample, at a random place in it
// (McKay, Beckman and Conover 1979, Technometrics 21:239). Precondition: count
// >= 1.
Eigen::MatrixXd LatinHypercube(int count, int dimensions, std::uint32_t seed);

// Returns the points of a grid with counts[k] >= 1 of them along coordinate k,
// its ends included; the last coordinate changes fastest. A coordinate with one
// point is in the middle.
Eigen::MatrixXd GridSamples(const std::vector<int>& counts);

// Returns how many points a grid has along each coordinate whose spacings are
// as alike as possible, of at most `most` points in all and at least 2 along
// each. `widths`: the ranges of the coordinates, above 0, in units that can be
// compared. Empty if `most` is too small.
std::vector<int> GridCounts(const std::vector<double>& widths, int most);

}  // namespace musclewarp
