// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/geometry/half_space.h"

namespace musclewarp {

// Moves `point` to the nearest one that is in all `count` half-spaces, to 1e-9
// mm. False, and the point as it was, if there is none, or none nearer than
// `farthest`, mm. Their normals are of unit length.
//
// A dual active set method (Goldfarb and Idnani, A numerically stable dual
// method for solving strictly convex quadratic programs, 1983): at most three
// borders hold a point, and one that is violated most takes the place of one
// that does not push any more.
bool ProjectIntoHalfSpaces(const HalfSpace* spaces,
                           int count,
                           double farthest,
                           Eigen::RowVector3d* point);

// Moves `point` towards the half-spaces, by some turns of Hildreth's method
// (1957): to a place between them where they have no point in common.
void ApproachHalfSpaces(const HalfSpace* spaces,
                        int count,
                        int turns,
                        Eigen::RowVector3d* point);

}  // namespace musclewarp
