// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// Returns true if a triangle and the box between two opposite corners share a
// point, on their borders or inside. The test is in floating point: near
// contact the answer may be wrong by rounding.
bool TriangleMeetsBox(const Corners& triangle,
                      const Eigen::RowVector3d& lower,
                      const Eigen::RowVector3d& upper);

}  // namespace musclewarp
