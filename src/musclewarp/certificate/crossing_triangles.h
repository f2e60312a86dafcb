// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/triangle_clusters.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/vertex_stars.h"

namespace musclewarp {

// A mesh at its current place. Keeps pointers.
struct SurfaceView {
  const Points* points = nullptr;
  const Triangles* triangles = nullptr;

  // They make searches faster if they are given, and are else done without or
  // made for a search.
  const VertexRings* rings = nullptr;
  const TriangleClusters* clusters = nullptr;
};

// Triangle f of mesh a and triangle g of mesh b, which share a point.
struct CrossingPair {
  int a, b;
  int f, g;
};

// Finds all pairs of triangles that share a point, by an exact test: of two
// muscles (a < b), of a muscle and a bone, and of one muscle with itself (a ==
// b, f < g), there beyond the corner or edge that the two have in common.
// Meshes are numbered muscles first, then bones. The pairs ascend.
//
// This is the core of the certificate. It shares only the exact tests with the
// code of contact: triangles of muscles are sorted into a uniform grid, where
// contact searches trees.
std::vector<CrossingPair> CrossingTriangles(
    const std::vector<SurfaceView>& muscles,
    const std::vector<SurfaceView>& bones);

}  // namespace musclewarp
