// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/geometry/solid_distance.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A mesh together with the signed distance to it, which refers to the mesh.
struct Solid {
  explicit Solid(TriangleSoup soup) : mesh(std::move(soup)), distance(mesh) {}

  const Points& points() const { return mesh.points(); }

  const SearchableMesh mesh;
  const SolidDistance distance;
};

}  // namespace musclewarp
