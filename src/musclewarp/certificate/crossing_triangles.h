// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/boxed_mesh.h"

namespace musclewarp {

// Triangle f of mesh a and triangle g of mesh b, which share a point.
struct CrossingPair {
  int a, b;
  int f, g;
};

// Finds all pairs of triangles that share a point, by an exact test: of two
// muscles (a < b), of a muscle and a bone, and of one muscle with itself (a ==
// b, f < g), there beyond the corner or edge that the two have in common. Of
// `meshes` the first `num_muscles` are muscles, the others bones. The pairs
// ascend.
//
// This is the core of the certificate. It shares only the exact tests with the
// code of contact: triangles of muscles are sorted into a uniform grid, where
// contact searches trees.
std::vector<CrossingPair> CrossingTriangles(
    const std::vector<BoxedMesh>& meshes, size_t num_muscles);

}  // namespace musclewarp
