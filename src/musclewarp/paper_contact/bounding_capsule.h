// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A capsule is the set of all points at most `radius` away from a segment. It
// bounds a long muscle more tightly than a box or a sphere, and whether two
// capsules overlap takes one distance between segments to tell.
struct Capsule {
  // The ends of the segment, mm.
  Eigen::RowVector3d start = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d end = Eigen::RowVector3d::Zero();
  // mm. A capsule with a negative radius is empty and overlaps nothing.
  double radius = -1;
};

// Returns a capsule that contains all points (#V x 3) and whose segment lies
// along their first principal axis, as in section 3.3 of the paper. Pairs of
// bodies whose capsules do not overlap cannot be in contact. The capsule is
// empty if there are no points.
Capsule BoundingCapsule(const Points& points);

// Returns true if the capsules share a point.
bool Overlap(const Capsule& a, const Capsule& b);

// Returns the distance between two segments, mm. Each is given by its start and
// end; a segment whose start and end are equal is a point.
double SegmentDistance(const Eigen::RowVector3d& a_start,
                       const Eigen::RowVector3d& a_end,
                       const Eigen::RowVector3d& b_start,
                       const Eigen::RowVector3d& b_end);

}  // namespace musclewarp
