// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// How many defects of each kind to plant in a mesh: those that segmentation
// and conversion leave behind.
struct PlantedDefects {
  // A point given twice; one triangle uses the copy, so that the surface is
  // torn along that triangle's two edges until the points are merged.
  int duplicate_points = 0;
  // An extra triangle with a corner repeated.
  int degenerate_triangles = 0;
  // An extra triangle standing on an edge: three triangles meet there.
  int flaps = 0;
  // A closed piece of about 3 mm beside the surface.
  int stray_pieces = 0;
  // A hole of one triangle.
  int missing_triangles = 0;
};

// The closed mesh with the defects planted at places that depend on the seed,
// at least 10 mm apart. Points of the surface keep their order; new ones
// follow.
TriangleSoup PlantDefects(const TriangleSoup& surface,
                          const PlantedDefects& defects,
                          uint32_t seed);

}  // namespace musclewarp
