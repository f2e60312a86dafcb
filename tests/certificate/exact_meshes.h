// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <optional>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The kernel rounds only where rounding cannot change an answer.
using MeshKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using MeshNumber = MeshKernel::FT;

// What two closed meshes have in common, in exact arithmetic, without any code
// of src/musclewarp/proximity, certificate or cgal.
struct ExactPair {
  int triangle_pairs = 0;           // that share a point
  int inside = 0;                   // vertices of one strictly inside the other
  MeshNumber squared_distance = 0;  // of triangles, mm^2
};

// Compares every triangle with every other. Returns nothing if a triangle has
// no area, for which CGAL gives no answer.
std::optional<ExactPair> CompareExactly(const TriangleSoup& a,
                                        const TriangleSoup& b);

}  // namespace musclewarp
