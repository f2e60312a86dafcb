// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// A place on a set of lines: t = 0 is the start of the segment, 1 its end.
struct SegmentPoint {
  int line = -1;
  int segment = -1;
  double t = 0;
};

// The place on `lines` nearest to a point in the rest pose; the first of equal
// ones. Precondition (CHECKed): there is a line.
SegmentPoint NearestSegment(const Eigen::RowVector3d& point,
                            const std::vector<ActionLine>& lines);

}  // namespace musclewarp
