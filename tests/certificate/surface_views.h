// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/certificate/crossing_triangles.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The view of a soup, which must outlive it.
inline SurfaceView ViewOf(const TriangleSoup& soup) {
  return {&soup.points, &soup.triangles};
}

}  // namespace musclewarp
