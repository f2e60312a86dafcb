// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// When a triangle is a sliver, and what may be done about it. A triangle is a
// sliver if its smallest height is below `aspect` times its longest edge, or
// below both `height` and `share_of_edges` times the mean edge of the mesh.
struct SliverLimits {
  // As a share of the longest edge of the triangle; 0: no triangle is a sliver.
  double aspect = 0.05;
  // In mm.
  double height = 0.25;
  // As a share of the mean edge length of the mesh.
  double share_of_edges = 0.1;
  // How far the surface may move, mm.
  double max_deviation = 0.1;

  // Returns true if the limits can be used; otherwise sets *error to a sentence
  // that names the field, its value and what is allowed.
  bool IsValid(std::string* error) const;
};

// What RemoveSlivers has done.
struct SliverRemovals {
  int collapsed_edges = 0;
  int flipped_edges = 0;
  // Slivers that could not be removed within the limits.
  int slivers_left = 0;
  // The largest distance that the surface moved, mm.
  double largest_deviation = 0;
};

// Removes slivers from a closed 2-manifold, the thinnest first. A smooth
// deformation turns slivers over long before their neighbours, and so does
// contact, which moves single vertices by fractions of a millimetre; a mesh
// without slivers can follow both without folding.
//
// One edge of a sliver is collapsed or flipped, whichever leaves the better
// triangles. A change that would fold the surface, make it cross itself, or
// move it by more than `max_deviation` is left out. Points and triangles that
// stay keep their order; a mesh without slivers is not changed. Precondition
// (CHECKed): the limits are valid.
SliverRemovals RemoveSlivers(const SliverLimits& limits, TriangleSoup* soup);

}  // namespace musclewarp
