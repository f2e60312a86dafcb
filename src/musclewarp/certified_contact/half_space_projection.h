// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/proximity/half_space.h"

namespace musclewarp {

// Projects a point onto the intersection of half-spaces: moves `point` to the
// nearest point within 1e-9 mm of all of them. Returns false and leaves `point`
// unchanged if the intersection is empty or farther away than `farthest` (mm),
// or if the method does not terminate within 60 changes of its active set.
// `spaces` is an array of `count` half-spaces, in any order.
//
// The method is the dual active set method of Goldfarb and Idnani, "A
// numerically stable dual method for solving strictly convex quadratic
// programs" (1983), for three unknowns. Its active set holds the at most three
// planes that push the point. It adds the most violated plane until none is
// violated, and drops planes whose multiplier would become negative.
bool ProjectIntoHalfSpaces(const HalfSpace* spaces,
                           int count,
                           double farthest,
                           Eigen::RowVector3d* point);

// Moves `point` to a compromise between `count` half-spaces without a common
// point nearby: to the minimum of the squared distance moved plus the square of
// `violation_weight` times the worst violation. The result does not depend on
// the order of the half-spaces or on duplicates. The method is that of
// ProjectIntoHalfSpaces, with the violation as a fourth unknown. If it does not
// terminate, the point is unchanged. Precondition: the weight is above zero.
void CompromiseBetweenHalfSpaces(const HalfSpace* spaces,
                                 int count,
                                 double violation_weight,
                                 Eigen::RowVector3d* point);

// Moves `point` towards the intersection of `count` half-spaces by at most
// `turns` rounds of Hildreth's method ("A quadratic programming procedure",
// 1957). If the intersection is empty, the point ends between the half-spaces,
// on the boundary of the last violated one. Otherwise it converges to its
// projection but may still be outside.
void ApproachHalfSpaces(const HalfSpace* spaces,
                        int count,
                        int turns,
                        Eigen::RowVector3d* point);

}  // namespace musclewarp
