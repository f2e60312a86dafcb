// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace musclewarp {

// The units that lengths may be given in, for messages.
constexpr char kLengthUnits[] = "mm, cm, m";

// Returns the millimetres in a unit of length, or nothing if the text is none
// of kLengthUnits.
std::optional<double> MillimetresPer(const std::string& unit);

// Throws InputError if no muscle has such a size, and says in which unit it
// might have been given instead. `diagonal` (mm) is that of its bounding box,
// `volume` in mm^3, if it is known; `mm_per_unit` is the unit that was stated.
// The bounds are far beyond those of animals: a muscle of a mouse's foot has
// some 0.3 mm^3.
void CheckMuscleSize(const std::string& where,
                     double diagonal,
                     std::optional<double> volume,
                     double mm_per_unit);

}  // namespace musclewarp
