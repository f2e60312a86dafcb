// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// A place on a set of lines of action. It is given by indices and a parameter
// instead of coordinates, so that it names the same place in every pose.
struct SegmentPoint {
  int line = -1;     // index of the line
  int segment = -1;  // segment i runs from point i to point i + 1 of the line
  double t = 0;      // 0 at the start of the segment, 1 at its end
};

// Returns the place on `lines` that is nearest to `point` (mm) in the rest
// pose, and the first of several that are equally near. Vertices of a muscle
// take their pre-rotation from there. Precondition (CHECKed): there is a line.
SegmentPoint NearestSegment(const Eigen::RowVector3d& point,
                            const std::vector<ActionLine>& lines);

}  // namespace musclewarp
