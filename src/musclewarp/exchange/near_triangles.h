// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// Returns for each triangle of a mesh (#F) whether it may be within `reach`,
// mm, of one of the surfaces: true of all that are, and of some that are a
// little farther, by their longest edge at most.
std::vector<bool> TrianglesWithin(
    double reach,
    const TriangleSoup& soup,
    const std::vector<const TriangleBvh*>& surfaces);

}  // namespace musclewarp
