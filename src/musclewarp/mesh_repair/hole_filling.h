// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The border of a hole: a closed walk of point indices, in the direction in
// which the triangles of a filling run along it, that is, against the triangles
// beside the hole. No point occurs twice.
using BorderLoop = std::vector<int>;

// Returns all borders of a mesh, cut into simple loops; a point in which two
// holes meet is in the loops of both. Precondition: the triangles are
// consistently oriented with at most two per edge.
std::vector<BorderLoop> FindBorderLoops(const Triangles& triangles);

// Returns the length of a border, mm.
double LoopLength(const BorderLoop& loop, const Points& points);

// Which holes may be filled. A filling invents surface, so a hole must either
// be small, or so narrow that hardly any surface is missing, or a face that got
// lost. With the length P of the border and the area A of the filling, a hole
// is filled if it has at most `max_edges` edges and
//
//   P <= max_perimeter   or   A <= max_slit_ratio P^2,
//
// or if it has at most `face_edges` edges. The second alternative means that a
// slit is filled however long it is: the two sides of a crack that was too wide
// to be stitched, for example. The third is for meshes with large triangles,
// such as the bones that come with OpenSim.
struct HoleLimits {
  // The longest border of a hole that is filled whatever its shape, mm.
  double max_perimeter = 30;

  // The largest A / P^2 of a slit. The ratio is 0.08 for a circle, 0.06 for a
  // square, and 0.006 for a slit 40 times as long as wide.
  double max_slit_ratio = 0.006;

  // A hole with at most so many edges is a triangle or quadrilateral that is
  // missing. It is filled whatever its size.
  int face_edges = 4;

  // A hole with more edges stays open, because the work of filling it grows
  // with the cube of their number.
  int max_edges = 800;

  // Returns true if no limit is negative; otherwise sets *error to a sentence
  // that names the field, its value and what is allowed.
  bool IsValid(std::string* error) const;
};

// What FillHoles has done.
struct Fillings {
  int holes = 0;
  // The holes among them that are filled only because they are missing faces.
  int missing_faces = 0;
  // Added triangles, and points added in the middle of chords.
  int triangles = 0;
  int points = 0;
  // The area of all fillings, mm^2.
  double area = 0;
  // The longest border of a filled hole, mm.
  double longest = 0;
};

// Fills every hole within the limits with the triangulation of its border that
// has the least area (Barequet and Sharir, "Filling gaps in the boundary of a
// polyhedron", 1995). A chord of the triangulation that is an edge of the mesh
// already would become non-manifold: it is avoided if the area then stays below
// twice the least, and otherwise split by a new point. New triangles and points
// follow the old ones. Preconditions: as for
// FindBorderLoops; the limits are valid (CHECKed).
Fillings FillHoles(const HoleLimits& limits, TriangleSoup* soup);

}  // namespace musclewarp
