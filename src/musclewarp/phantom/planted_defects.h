// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// How many defects of each kind to plant in a mesh. The kinds are those that
// segmentation and conversion leave behind; as their numbers are known, tests
// can compare what repair reports.
struct PlantedDefects {
  // Points that are given twice. One triangle uses the copy, so that the
  // surface is torn along two edges of that triangle until the points are
  // merged.
  int duplicate_points = 0;
  // Extra triangles with a repeated corner.
  int degenerate_triangles = 0;
  // Extra triangles that stand on an edge, where three triangles then meet.
  int flaps = 0;
  // Closed pieces, 3 mm wide, beside the surface.
  int stray_pieces = 0;
  // Holes of one triangle.
  int missing_triangles = 0;
};

// Returns a closed mesh with the defects planted in it, at places that depend
// on the seed and are at least 10 mm apart. Points of the surface keep their
// order; new points follow.
TriangleSoup PlantDefects(const TriangleSoup& surface,
                          const PlantedDefects& defects,
                          uint32_t seed);

}  // namespace musclewarp
