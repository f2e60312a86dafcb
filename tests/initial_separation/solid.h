// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "musclewarp/initial_separation/solid_distance.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {

// Of sums and differences of distances, mm.
inline constexpr double kDistanceRounding = 1e-12;

// A mesh together with the signed distance to it, which refers to the mesh.
struct Solid {
  explicit Solid(TriangleSoup soup) : mesh(std::move(soup)), distance(mesh) {}

  const Points& points() const { return mesh.points(); }

  const SearchableMesh mesh;
  const SolidDistance distance;
};

}  // namespace musclewarp
