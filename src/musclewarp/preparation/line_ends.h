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
  std::string body;     // to which it belongs
  double distance = 0;  // mean distance of the line ends from its bones, mm
};

// A muscle whose ends are farther from their bones than this was segmented too
// short, or ends on another bone, mm.
constexpr double kFarEnd = 15;

// Returns the ends of lines at rest, by body: first those at their first
// points, then those at their last points. Bodies without bones are omitted.
std::vector<LineEnd> LineEndsOf(const std::vector<ActionLine>& lines,
                                const std::vector<BodySurface>& bodies);

// Returns a warning for each end of a muscle whose distance exceeds kFarEnd, or
// one for both if the warnings are the same. Lengths are in units of
// `body_size` mm (Scene::body_size).
std::vector<std::string> FarEndWarnings(const std::string& muscle,
                                        const std::vector<LineEnd>& ends,
                                        double body_size);

}  // namespace musclewarp
