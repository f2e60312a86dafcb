// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// A number of an .inp file has at most this many characters: Abaqus allows no
// more, and CalculiX reads no more, so that it takes -7.61363549309262e-05,
// which has one more, for -7.6.
constexpr int kMostAbaqusCharacters = 20;

// Returns a number with as many significant digits, up to `most_digits`, as
// have room in kMostAbaqusCharacters, without those that change nothing; the
// locale does not matter. Of 17 digits there is room for all from which the
// same double is read again if the number is 0.1 or larger, but for the very
// large; in any other number for 14, or 13 below 1e-99 and above 1e100.
std::string AbaqusNumber(double value, int most_digits = 17);

}  // namespace musclewarp
