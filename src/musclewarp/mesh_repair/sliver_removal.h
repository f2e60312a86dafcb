// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A sliver is a triangle whose smallest height is below one of these.
struct SliverLimits {
  double aspect = 0.05;         // of its longest edge; 0: there are none
  double height = 0.25;         // mm
  double share_of_edges = 0.1;  // of the mean edge, if that is less than height
  double max_deviation = 0.1;   // of the surface, mm

  // Returns true if the limits can be used; otherwise sets *error to a sentence
  // that names the field, its value and what is allowed.
  bool IsValid(std::string* error) const;
};

struct SliverRemovals {
  int collapsed_edges = 0;
  int flipped_edges = 0;
  int slivers_left = 0;          // that could not go
  double largest_deviation = 0;  // of the surface, mm
};

// Takes slivers out of a closed 2-manifold, the thinnest first: an edge of them
// is collapsed or flipped, whichever leaves the better triangles, where the
// surface neither folds nor crosses itself, nor goes farther than allowed from
// where it was. What
// deforms smoothly turns slivers over long before their neighbours, and
// contact, which moves single vertices by fractions of a millimetre, too.
// Points and triangles that stay keep their order; without slivers nothing
// changes. Precondition (CHECKed): the limits are valid.
SliverRemovals RemoveSlivers(const SliverLimits& limits, TriangleSoup* soup);

}  // namespace musclewarp
