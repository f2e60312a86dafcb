// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace musclewarp {

// What a run measured of a path in a frame.
struct PathSample {
  Eigen::VectorXd coordinates;  // rad or m
  double length = 0;            // mm
  Eigen::VectorXd arms;         // -dl/dq of each coordinate, mm per rad or m
};

}  // namespace musclewarp
