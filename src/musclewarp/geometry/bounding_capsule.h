// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// All points at most `radius` from a segment, mm.
struct Capsule {
  Eigen::RowVector3d start = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d end = Eigen::RowVector3d::Zero();
  double radius = -1;  // negative: empty, overlaps nothing
};

// A capsule along the first principal axis of the points that contains all of
// them; paper section 3.3. Empty for no points.
Capsule BoundingCapsule(const Points& points);

// True if the capsules share a point.
bool Overlap(const Capsule& a, const Capsule& b);

// The distance of two segments, either of which may be a point, mm.
double SegmentDistance(const Eigen::RowVector3d& a_start,
                       const Eigen::RowVector3d& a_end,
                       const Eigen::RowVector3d& b_start,
                       const Eigen::RowVector3d& b_end);

}  // namespace musclewarp
