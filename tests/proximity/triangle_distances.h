// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "musclewarp/proximity/triangle_distance.h"

namespace musclewarp {

inline double DistanceOf(const Corners& a, const Corners& b) {
  return std::sqrt(ClosestPointsOfTriangles(a, b).squared_distance);
}

}  // namespace musclewarp
