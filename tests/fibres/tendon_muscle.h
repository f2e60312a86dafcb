// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "support/meshes.h"

namespace musclewarp {

// A muscle along z from -60 to 60 mm, up to 20 mm thick, whose part above 15 mm
// is a tendon less than 0.6 mm thick.
inline TriangleSoup MuscleWithTendon() {
  TriangleSoup muscle = Spindle(10, 60, 4);
  for (Eigen::Index i = 0; i < muscle.points.rows(); ++i) {
    const double z = std::max(0.0, muscle.points(i, 2));
    muscle.points.row(i).head<2>() *= std::max(0.03, 1 - z / 15);
  }
  return muscle;
}

}  // namespace musclewarp
