// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns a closed surface that does not cross itself with triangles of one
// size, which do not either: around places where large triangles would cross,
// it keeps the small ones of the surface, more and more of them. `finish`, if
// given, moves the new vertices before crossings are looked for. Returns the
// surface as it is if that does not help. Preconditions as for Remeshed()
// (cgal/even_remeshing.h).
TriangleSoup RemeshedWithoutCrossings(
    const TriangleSoup& surface,
    double edge_length,
    const std::function<void(TriangleSoup*)>& finish = {});

}  // namespace musclewarp
