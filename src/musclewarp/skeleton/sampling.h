// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

// Returns places along the lines for the skeleton rows, the terms that pull a
// muscle along its lines (paper, section 2.2). They are both ends of every
// segment, once where segments meet, and points between them at equal distances
// of at most `spacing` (mm) in the rest pose. They are ordered by line and
// along it. Precondition (CHECKed): spacing is above 0.
std::vector<SegmentPoint> SampleLines(const std::vector<ActionLine>& lines,
                                      double spacing);

// Returns the length of line that each sample stands for, mm: half of the way
// to its neighbours on the line. `samples` are those of SampleLines().
Eigen::VectorXd SampleLengths(const std::vector<ActionLine>& lines,
                              const std::vector<SegmentPoint>& samples);

// Returns into how many pieces of at most `spacing` a segment is cut, both mm.
int NumPieces(double length, double spacing);

// Returns the coordinates (mm) of a place on a polyline (#P x 3), which is the
// line place.line in some pose. The same place gives the rest sample on the
// rest line and its target on the target line.
Eigen::RowVector3d PointOnSegment(const Points& polyline,
                                  const SegmentPoint& place);

}  // namespace musclewarp
