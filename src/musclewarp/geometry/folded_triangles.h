// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Triangles that a deformation folded over: their normal points against their
// rest normal turned by the rotation of their surroundings. That rotation is
// the best fit (Kabsch) of the triangle's vertices and their neighbours up to
// two edges away, so that one folded triangle does not turn its own reference.
// Needles too thin for their normal to be more than rounding do not count.
// Rest and deformed positions are #V x 3.
std::vector<int> FoldedTriangles(const Points& rest,
                                 const Points& deformed,
                                 const Triangles& triangles);

}  // namespace musclewarp
