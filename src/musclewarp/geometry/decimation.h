// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// How far a mesh is simplified.
struct DecimationOptions {
  int max_triangles = 0;  // it ends as soon as no more are left

  // The largest distance of what is removed from what takes its place, mm.
  double tolerance = std::numeric_limits<double>::infinity();

  // By vertex, or empty: those that stay, with the triangles between them.
  std::vector<bool> is_kept = {};
};

// A simplified mesh.
struct Decimation {
  TriangleSoup soup;

  // For each of its vertices the number of the same vertex in the original, in
  // no order: none is moved.
  std::vector<int> vertices;

  // The largest distance of a vertex of the original to the simplified
  // surface, mm.
  double max_error = 0;
};

// Simplifies a mesh by collapsing the edges with the least quadric error
// (Garland and Heckbert 1997, the decimater of OpenMesh). A mesh that is small
// enough already, or not a closed 2-manifold, is returned as it is.
// Precondition (CHECKed): `is_kept` is empty or has a value for each vertex.
Decimation Decimated(const TriangleSoup& soup,
                     const DecimationOptions& options);

}  // namespace musclewarp
