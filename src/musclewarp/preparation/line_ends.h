// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// An end of the lines that were made for a muscle.
struct LineEnd {
  std::string body;     // on which it is
  double distance = 0;  // of the lines' ends from its bones, on average, mm
};

// A muscle whose ends are farther from their bones was segmented too short, or
// ends on another bone, mm.
constexpr double kFarEnd = 15;

// Returns the ends of lines at rest: those of their first points, then those of
// their last ones, by body. Bodies without bones are left out.
std::vector<LineEnd> LineEndsOf(const std::vector<ActionLine>& lines,
                                const std::vector<BodySurface>& bodies);

// Returns a warning for each end of a muscle beyond kFarEnd, or one for both if
// they are alike. Lengths are in units of `body_size` mm (Scene::body_size).
std::vector<std::string> FarEndWarnings(const std::string& muscle,
                                        const std::vector<LineEnd>& ends,
                                        double body_size);

}  // namespace musclewarp
