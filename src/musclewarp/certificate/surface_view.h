// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/certificate/triangle_clusters.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/vertex_stars.h"

namespace musclewarp {

// A mesh at its current place. Keeps pointers.
struct SurfaceView {
  const Points* points = nullptr;
  const Triangles* triangles = nullptr;

  // They make searches faster if they are given, and are else done without or
  // made for a search.
  const VertexRings* rings = nullptr;
  const TriangleClusters* clusters = nullptr;
};

}  // namespace musclewarp
