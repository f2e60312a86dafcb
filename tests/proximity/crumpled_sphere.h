// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/meshes.h"

namespace musclewarp {

// A sphere whose vertices have moved at random, by so much (mm) at most.
inline TriangleSoup CrumpledSphere(double by, std::uint32_t seed) {
  TriangleSoup sphere = Icosphere(10, 3);
  sphere.points += by * RandomPoints(sphere.points.rows(), seed);
  return sphere;
}

}  // namespace musclewarp
