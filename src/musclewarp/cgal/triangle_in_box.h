// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// Returns true if a triangle meets the box between two corners, its border
// included, up to rounding.
bool TriangleMeetsBox(const Corners& triangle,
                      const Eigen::RowVector3d& lower,
                      const Eigen::RowVector3d& upper);

}  // namespace musclewarp
