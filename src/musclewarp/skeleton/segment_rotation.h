// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

// The smallest rotation that turns direction `from` into `to` (any lengths).
// Opposite directions turn by pi about an axis that depends on `from` alone;
// the identity if either is zero.
Eigen::Matrix3d SmallestRotation(const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to);

// Angle in (-pi, pi] of the part of `rotation` that turns about `axis` (a unit
// vector): the twist of its swing-twist decomposition. 0 for a rotation by pi
// about an axis normal to `axis`, where twist has no meaning.
double TwistAngle(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& axis);

// The pre-rotation R_s of the Laplacian rows at a place on a line (paper
// section 2.2): the smallest rotation from the rest to the target direction of
// the segment. Directions leave the twist about the segment open. Where the
// bodies of its ends are known and `use_body_twist`, their twist is added,
// turned evenly from one end to the other; an end without body follows the
// other end. So a rigid motion of all bodies gives exactly its rotation.
Eigen::Matrix3d SegmentRotation(const ActionLine& line,
                                const LineTarget& target,
                                const SegmentPoint& place,
                                bool use_body_twist);

}  // namespace musclewarp
