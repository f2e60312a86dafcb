// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the vertices of a fine mesh that may get contact rows in the coarse
// solve of a muscle (PlaneSet::MostViolated): those nearest to `count` places
// spread evenly over its hull, each once, in rising order. Fine meshes of one
// surface in one hull have them at the same places to within an edge, however
// fine they are: places chosen among the vertices themselves would be others on
// every mesh. `fine`: #V x 3, mm.
std::vector<int> ContactSamples(const Points& fine,
                                const TriangleSoup& hull,
                                int count);

}  // namespace musclewarp
