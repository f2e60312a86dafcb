// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Closed walk of point indices along a border, as the triangles of a filling
// run: against those beside it. No point occurs twice.
using BorderLoop = std::vector<int>;

// All borders, cut into simple loops; a point where two holes meet is in both.
// Precondition: consistently oriented, at most two triangles an edge.
std::vector<BorderLoop> FindBorderLoops(const Triangles& triangles);

double LoopLength(const BorderLoop& loop, const Points& points);  // mm

struct HoleLimits {
  // Holes whose border is at most this long are filled, mm.
  double max_perimeter = 30;

  // Slits are filled however long they are: holes whose filling has at most
  // this area over the square of the perimeter (circle 0.08, square 0.06, a
  // slit 40 times as long as wide 0.006).
  double max_slit_ratio = 0.006;

  // A loop of more edges stays open: the work grows with the cube.
  int max_edges = 800;

  // Returns true if no limit is negative; otherwise sets *error to a sentence
  // that names the field, its value and what is allowed.
  bool IsValid(std::string* error) const;
};

struct Fillings {
  int holes = 0;
  int triangles = 0;
  int points = 0;
  double area = 0;     // mm^2
  double longest = 0;  // perimeter, mm
};

// Fills every hole within the limits with the triangulation of its loop that
// has the least area. A chord that is an edge of the mesh already is avoided or
// gets a point in its middle. New triangles and points go to the end.
// Precondition (CHECKed): the limits are valid.
Fillings FillHoles(const HoleLimits& limits, TriangleSoup* soup);

}  // namespace musclewarp
