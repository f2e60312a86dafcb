// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Two closed meshes without crossings of their own, and what is special about
// them.
struct MeshPair {
  std::string kind;
  TriangleSoup a, b;
};

// Returns two small meshes in a position that is hard for tests of
// intersection: touching in a corner, an edge or a face, in one plane, equal,
// nested, needles, an ulp apart, up to 9e6 mm from the origin. The same for the
// same seed.
MeshPair RandomMeshPair(unsigned seed);

}  // namespace musclewarp
