// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/proximity/half_space.h"

namespace musclewarp {

// Projects a point into the intersection of half-spaces: moves `point` to the
// nearest point that is in all of them, up to 1e-9 mm. Returns false and leaves
// `point` as it was if their intersection is empty, or farther away than
// `farthest` (mm), or if the method does not end within 60 changes of its
// active set. `spaces` is an array of `count` half-spaces, in any order.
//
// The method is the dual active set method of Goldfarb and Idnani, "A
// numerically stable dual method for solving strictly convex quadratic
// programs" (1983), for three unknowns. It keeps the at most three planes that
// push the point and adds the most violated one until none is violated. A plane
// that would have to pull is dropped.
bool ProjectIntoHalfSpaces(const HalfSpace* spaces,
                           int count,
                           double farthest,
                           Eigen::RowVector3d* point);

// Moves `point` to a compromise between `count` half-spaces that have no common
// point, or none that is near: where the square of the way plus the square of
// `violation_weight` times the worst violation is least. It does not depend on
// the order of the half-spaces, nor on how many of them say the same. The
// method is the same, with the violation as a fourth unknown. If it does not
// end, the point stays. Precondition: the weight is above zero.
void CompromiseBetweenHalfSpaces(const HalfSpace* spaces,
                                 int count,
                                 double violation_weight,
                                 Eigen::RowVector3d* point);

// Moves `point` towards the intersection of `count` half-spaces by at most
// `turns` rounds of Hildreth's method ("A quadratic programming procedure",
// 1957). If the intersection is empty, the point ends between the half-spaces,
// on the border of the last one that it violated. If it is not, the point
// approaches its projection but may still be outside.
void ApproachHalfSpaces(const HalfSpace* spaces,
                        int count,
                        int turns,
                        Eigen::RowVector3d* point);

}  // namespace musclewarp
