// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The options of OuterHull.
struct OuterHullOptions {
  // The number of vertices that the hull should have, roughly. A hull with more
  // vertices follows the shape more closely and makes solving slower.
  int coarse_vertices = 200;

  // The distance of the hull from the mesh, as a fraction of the square root of
  // the area of the mesh, but at least 2/15 of the length of the hull's edges:
  // nearer hulls have slivers. As the number of vertices grows, hulls at a
  // fixed distance approach one surface, and so does the deformed shape, which
  // depends on how far the hull is from the lines of the muscle.
  double relative_distance = 0.025;

  // A hull whose number of vertices differs from coarse_vertices by at most
  // this share of it is taken at once.
  double count_tolerance = 0.15;

  // At most this many hulls are made, of which the one nearest to the wanted
  // number of vertices is taken. Each takes some tenths of a second.
  int max_wraps = 5;

  // Returns true if the options can be used; otherwise sets *error to a
  // sentence that names the field and the rule.
  bool IsValid(std::string* error) const;
};

// Returns a coarse mesh around a fine one, the "coarse outer hull" of section
// 2.1 of the paper: a closed, outward oriented 2-manifold that strictly
// encloses `fine`. Deforming the hull instead of the fine mesh keeps the number
// of unknowns small, and mean value coordinates carry the deformation over.
//
// `fine` may be any triangle soup, before or after repair. If it has several
// pieces that are too far apart for one hull, the result encloses only the
// piece whose hull has the largest volume. Precondition (CHECKed): the options
// are valid. Throws InputError in a build without MUSCLEWARP_WITH_ALPHA_WRAP.
TriangleSoup OuterHull(const TriangleSoup& fine,
                       const OuterHullOptions& options);

// Returns true if every vertex, edge and face of `fine` lies strictly inside
// `hull`, by exact tests. Returns false if the hull is open or inside out.
// Points of `fine` that no triangle uses do not count.
bool Encloses(const TriangleSoup& hull, const TriangleSoup& fine);

}  // namespace musclewarp
