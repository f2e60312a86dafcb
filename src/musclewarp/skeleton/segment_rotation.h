// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

// Returns the smallest rotation that turns the direction of `from` into that of
// `to`. The vectors may have any lengths; if one of them is zero, the result is
// the identity. Opposite directions are turned into each other by pi about an
// axis that depends on `from` alone.
Eigen::Matrix3d SmallestRotation(const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to);

// Returns the angle (rad, in [-pi, pi]) by which `rotation` turns about `axis`,
// a vector of unit length: the twist of its swing-twist decomposition. It is 0
// for a rotation by pi about an axis orthogonal to `axis`, for which the twist
// is not defined.
double TwistAngle(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& axis);

// Returns the pre-rotation R_s of the Laplacian rows at a place on a line
// (paper, section 2.2). Rotating the rest Laplacians before the solve lets a
// muscle turn with its line without resistance.
//
// The pre-rotation is the smallest rotation from the rest direction of the
// segment to its target direction, which leaves open how far the muscle turns
// about the segment, its twist. If `use_body_twist` is
// true and the bodies at the ends of the segment are known, their twist is
// added. It changes linearly from one end to the other, the short way round; an
// end without a body takes the twist of the other end. A rigid motion of all
// bodies then gives exactly its rotation.
Eigen::Matrix3d SegmentRotation(const ActionLine& line,
                                const LineTarget& target,
                                const SegmentPoint& place,
                                bool use_body_twist);

}  // namespace musclewarp
