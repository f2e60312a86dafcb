// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

// Places along the lines for the skeleton rows, paper section 2.2: both ends of
// every segment and, between them, points at most `spacing` mm apart in the
// rest pose, evenly. Precondition (CHECKed): spacing > 0.
std::vector<SegmentPoint> SampleLines(const std::vector<ActionLine>& lines,
                                      double spacing);

// A place on a polyline (#P x 3): the same parameters give the rest sample on
// the rest line and its target on the target line.
Eigen::RowVector3d PointOnSegment(const Points& polyline,
                                  const SegmentPoint& place);

}  // namespace musclewarp
