// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Maps points (#V x 3, mm) from frame a to frame b. `b_from_a` is an affine map
// in homogeneous coordinates, the translation in mm:
// x_in_b = R x_in_a + t for the upper rows (R | t).
Points Transformed(const Points& points, const Eigen::Matrix4d& b_from_a);

// Returns a box in frame b around a box in frame a: that of its corners.
Box3 Transformed(const Box3& box, const Eigen::Matrix4d& b_from_a);

// Returns a_from_b. Precondition: `b_from_a` is rigid; the rotation is inverted
// by transposition.
Eigen::Matrix4d RigidInverse(const Eigen::Matrix4d& b_from_a);

}  // namespace musclewarp
