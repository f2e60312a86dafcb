// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {

// Where the vertices of muscles lie in their medial cells, from an earlier
// separation of the same scene in which some meshes were others.
struct KnownCells {
  std::vector<TriangleSoup> muscles, bones;  // as they were
  std::vector<Points> projected;             // by muscle, #V x 3, mm
};

// Returns by muscle whether it and all meshes within `reach` (mm) of it are the
// same as they were, so that its cell is, too. `known` may be empty.
std::vector<char> AreStillKnown(
    const KnownCells& known,
    const std::vector<const SearchableMesh*>& muscles,
    const std::vector<const SearchableMesh*>& bones,
    double reach);

// Remembers the projections of the muscles, in the order of `muscles`.
void Remember(const std::vector<const SearchableMesh*>& muscles,
              const std::vector<const SearchableMesh*>& bones,
              const std::vector<Points>& projected,
              KnownCells* known);

}  // namespace musclewarp
