// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct OuterHullOptions {
  int coarse_vertices = 200;
};

// A coarse closed 2-manifold around `fine`.
TriangleSoup OuterHull(const TriangleSoup& fine,
                       const OuterHullOptions& options);

// True if every vertex, edge and face of `fine` lies strictly inside `hull`.
bool Encloses(const TriangleSoup& hull, const TriangleSoup& fine);

}  // namespace musclewarp
