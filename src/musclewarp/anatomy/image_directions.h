// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace musclewarp {

// Returns the directions forward, up and right, in columns, in a frame with the
// given axes ("LPS"). Precondition (CHECKed): the axes are valid, as those of a
// scene.
Eigen::Matrix3d DirectionsOfAxes(const std::string& axes);

}  // namespace musclewarp
