// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

inline Corners CornersOf(const Eigen::RowVector3d& a,
                         const Eigen::RowVector3d& b,
                         const Eigen::RowVector3d& c) {
  Corners triangle;
  triangle << a, b, c;
  return triangle;
}

// A triangle with coordinates between -size and size.
inline Corners RandomTriangle(std::mt19937* random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  Corners triangle;
  for (int i = 0; i < 9; ++i) triangle.data()[i] = uniform(*random);
  return triangle;
}

}  // namespace musclewarp
