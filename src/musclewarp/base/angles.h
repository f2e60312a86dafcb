// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace musclewarp {

// The factors between both units, for values that may be angles:
// "is_angle ? kRadiansPerDegree : 1". A product with them may differ in the
// last bit from what the functions below return.
constexpr double kRadiansPerDegree = M_PI / 180;
constexpr double kDegreesPerRadian = 180 / M_PI;

// Returns an angle given in degrees in radians: RadiansOf(180) is pi.
constexpr double RadiansOf(double degrees) { return degrees * M_PI / 180; }

// Returns an angle given in radians in degrees: DegreesOf(M_PI) is 180.
constexpr double DegreesOf(double radians) { return radians * 180 / M_PI; }

}  // namespace musclewarp
