// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns a surface that encloses a triangle soup, however bad the soup is:
// holes, doubled triangles and self-intersections do no harm. The surface is a
// closed 2-manifold, oriented outward and free of self-intersections, and all
// triangles of the soup lie strictly inside it, except that triangles without
// area are ignored. The surface does not enter pockets narrower than `alpha`
// and stays about `offset` away from the soup, both in mm.
//
// The algorithm is that of Portaneri et al., "Alpha Wrapping with an Offset"
// (2022), as CGAL implements it. Preconditions (CHECKed): the soup has
// triangles; alpha and offset are above 0.
//
// CGAL's implementation is under the GPL, and this is the only function of the
// library that needs it. It is left out of builds without
// MUSCLEWARP_WITH_ALPHA_WRAP; callers should use OuterHull, which reports that
// as an InputError.
TriangleSoup AlphaWrap(const TriangleSoup& soup, double alpha, double offset);

}  // namespace musclewarp
