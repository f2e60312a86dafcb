// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace musclewarp {

// Returns "(x, y, z)" with a tenth of a millimetre: a place, mm, in a sentence
// for the user.
std::string PlaceText(const Eigen::RowVector3d& place);

// Returns a number with three significant digits, "26.7" or "0.00512", as
// sentences have measures whose size is not known beforehand.
std::string MeasureText(double value);

}  // namespace musclewarp
