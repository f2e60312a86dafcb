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

  // How much it counts, from 0 to 1. One that counts less than others holds a
  // function where nothing better is known, and no function is judged by it.
  double weight = 1;
};

}  // namespace musclewarp
