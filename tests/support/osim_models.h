// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Small OpenSim models as text. Both have the bodies "thigh" and "shank": a
// thigh fixed to the ground by a weld, and a shank on a knee at (0, -0.4, 0) m
// of the thigh whose place on the shank is its own origin.

// OpenSim 4. `joint` is an element of the joint set that joins the shank to the
// thigh; its frames are "thigh_offset" and "shank_offset".
std::string Model4(const std::string& joint,
                   const std::string& constraints = "",
                   const std::string& forces = "");

// A joint for Model4 of some type, with coordinates of those names (separated
// by blanks); `rest` is what follows its frames.
std::string Joint4(const std::string& type,
                   const std::string& coordinates,
                   const std::string& rest = "");

// A <SpatialTransform>: six axes, of which each is "coordinates|axis|function
// element".
std::string Axis4(const std::string& coordinates,
                  const std::string& axis,
                  const std::string& function);
std::string SpatialTransform(const std::string& axes);
std::string FreeAxes(int from, int to);  // constant axes from..to - 1

// OpenSim 3, with the same hinge of one coordinate "knee" about z.
std::string Model3(const std::string& joint_extra = "",
                   const std::string& forces = "");

// A muscle with a path for either version.
std::string Muscle(const std::string& name, const std::string& points);
std::string Point4(const std::string& name,
                   const std::string& body,
                   const std::string& location,
                   const std::string& type = "PathPoint",
                   const std::string& extra = "");

// Writes the text to a file of the running test and returns its path.
std::string Written(const std::string& name, const std::string& text);

// Returns a text with the first `from`, which it must have, replaced.
std::string Replaced(std::string text,
                     const std::string& from,
                     const std::string& to);

}  // namespace musclewarp
