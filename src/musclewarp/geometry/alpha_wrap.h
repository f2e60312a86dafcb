// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// CGAL's alpha wrap (Portaneri et al. 2022, "Alpha Wrapping with an Offset"): a
// closed, outward 2-manifold without self-intersections that strictly encloses
// any triangle soup. It enters no pocket narrower than alpha and stays about
// `offset` away, both in mm. The only file under the GPL's reach; it is built
// with MUSCLEWARP_WITH_ALPHA_WRAP. Preconditions: triangles, alpha and offset
// above 0.
TriangleSoup AlphaWrap(const TriangleSoup& soup, double alpha, double offset);

}  // namespace musclewarp
