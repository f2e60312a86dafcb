// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace musclewarp {

// The supported units of length, for messages.
constexpr char kLengthUnits[] = "mm, cm, m";

// Returns the number of millimetres in a unit of length, or nothing if the text
// is none of kLengthUnits.
std::optional<double> MillimetresPer(const std::string& unit);

// Throws InputError if a mesh is too small or too large for a muscle; the
// message suggests units in which the mesh may have been given. `diagonal` (mm)
// is the diagonal of its bounding box, `volume` its volume (mm^3), if known;
// `mm_per_unit` is the stated unit. The bounds are far beyond the muscles of
// animals: a muscle in the foot of a mouse has about 0.3 mm^3.
void CheckMuscleSize(const std::string& where,
                     double diagonal,
                     std::optional<double> volume,
                     double mm_per_unit);

}  // namespace musclewarp
