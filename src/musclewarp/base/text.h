// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace musclewarp {

// Returns "(x, y, z)": a place in a sentence for the user, in mm with a tenth
// of a millimetre. `place` is given in units of `body_size` mm
// (Scene::body_size); below 1 there are more digits.
std::string PlaceText(const Eigen::RowVector3d& place, double body_size = 1);

// Returns a number with up to this many significant digits, without trailing
// zeros: "0.25", "1e-07".
std::string NumberText(double value, int digits = 6);

// Returns a number with this many digits behind the point, "12.30", and more
// for a body of less than human size (Scene::body_size).
std::string RoundedText(double value, int digits, double body_size = 1);

// Returns an angle, rad, in degrees with this many digits behind the point:
// "12 degrees".
std::string DegreesText(double angle, int digits = 0);

// Returns a number with three significant digits, or all before the point,
// "26.7", "0.00512" or "2410", as sentences have measures whose size is not
// known beforehand.
std::string MeasureText(double value);

// Returns a number with this many digits behind the point, and up to five more
// if these are fewer than three significant ones: "43.6", "0.0054".
std::string FixedText(double value, int digits);

// Returns a length in units of `body_size` mm as text: "3.4 mm".
std::string LengthText(double length, double body_size = 1);

// Returns "1/32 of" or "16 times", to stand before "human size".
std::string BodySizeText(double body_size);

// Returns the parts of a text between separators, in their order. Parts may be
// empty, but not the last: "a,,b" has three parts, "a," has one, and an empty
// text has none.
std::vector<std::string> Split(const std::string& text, char separator);

}  // namespace musclewarp
