// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

// The part of a line along which a muscle lies, in mm along the line from its
// beginning. A line may go on beyond the muscle, for example through a tendon
// that is no part of the muscle's mesh.
struct CoveredPart {
  double begin = 0, end = 0;
  double length = 0;  // of the whole line
};

// Returns the part of a polyline (#P x 3, mm) between the first and the last of
// the places that are nearest to points of the muscle (#V x 3, mm).
// Preconditions (CHECKed): the polyline has at least two points, and there is a
// point of the muscle.
CoveredPart PartAlong(const Points& line, const Points& muscle);

// Returns the samples (SampleLines) that lie along the muscle or at most 15 mm
// beyond it: what is farther away says nothing of the muscle, whose mean value
// coordinates do not reach there. All samples of a line are kept if fewer than
// two of it would be left.
std::vector<SegmentPoint> SamplesAlong(const std::vector<SegmentPoint>& samples,
                                       const std::vector<ActionLine>& lines,
                                       const Points& muscle);

}  // namespace musclewarp
