// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct OuterHullOptions {
  // About how many vertices the hull should have. More follow the shape more
  // closely and make solving slower.
  int coarse_vertices = 200;

  // How far from that number, relative, a hull may be without another try.
  double count_tolerance = 0.15;

  // Wraps to try, each some tenths of a second; the nearest to the wanted
  // number is taken.
  int max_wraps = 5;

  bool IsValid(std::string* error) const;
};

// A coarse closed, outward oriented 2-manifold that strictly encloses `fine`
// (any triangle soup, as delivered or repaired): the coarse outer hull of paper
// section 2.1. Of several pieces too far apart for one hull, the one whose hull
// has the largest volume is enclosed. Throws InputError in a build without
// MUSCLEWARP_WITH_ALPHA_WRAP.
TriangleSoup OuterHull(const TriangleSoup& fine,
                       const OuterHullOptions& options);

// True if every vertex, edge and face of `fine` lies strictly inside `hull`, by
// exact tests; false for hulls that are open or inside out.
bool Encloses(const TriangleSoup& hull, const TriangleSoup& fine);

}  // namespace musclewarp
