// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// #V x 3 points of frame a in frame b; b_from_a is an affine map, mm.
Points Transformed(const Points& points, const Eigen::Matrix4d& b_from_a);

// a_from_b of a rigid b_from_a.
Eigen::Matrix4d RigidInverse(const Eigen::Matrix4d& b_from_a);

}  // namespace musclewarp
