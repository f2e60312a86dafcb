// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A mesh where it is.
struct SurfaceView {
  const Points* points = nullptr;
  const Triangles* triangles = nullptr;
};

// Triangle f of mesh a and triangle g of mesh b.
struct CrossingPair {
  int a, b;
  int f, g;
};

// All pairs of triangles that share a point: of two muscles (a < b), of a
// muscle and a bone, and of one muscle (a == b, f < g), there beyond the corner
// or edge they have in common. Meshes are numbered muscles first, then bones.
// Ascending.
//
// For a certificate: of what contact uses to find crossings this shares the
// exact tests alone. Triangles are sorted into a uniform grid instead of trees.
std::vector<CrossingPair> CrossingTriangles(
    const std::vector<SurfaceView>& muscles,
    const std::vector<SurfaceView>& bones);

}  // namespace musclewarp
