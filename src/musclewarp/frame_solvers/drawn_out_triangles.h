// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/frames/triangle_stretch.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Options of RemoveDrawnOutTriangles.
struct DrawnOutOptions {
  // Triangles that are stretched more than this are removed, a ratio of
  // lengths. Less than muscles bear (kStretchBeyondAnatomy), as the relaxation
  // that follows stretches other triangles a little.
  double max_stretch = 1.5;

  // The largest distance that the surface may move in either shape, mm: a voxel
  // of a fine scan.
  double max_deviation = 0.5;

  bool IsValid(std::string* error) const;
};

// Removes the triangles of a surface that are drawn out between its two shapes,
// such as small ones that contact has pushed apart in the rest pose. An edge of
// each, the most stretched first, is collapsed onto one of its ends, whichever
// leaves the least stretch, if that is less than before, no triangle turns in
// either shape, and none becomes a sliver.
//
// Vertices only vanish: returns the indices of those that stay (in rising
// order), which `rest->points` then holds. `moved`: the other shape, #V x 3,
// mm. `locked`: #V, true for vertices whose edges are not collapsed. Where
// sheets lie close to each other, they may come to cross: the caller has to
// test that. Preconditions (CHECKed): the options are valid, and there are as
// many `moved` and `locked` as points; the mesh is a closed manifold.
std::vector<int> RemoveDrawnOutTriangles(const DrawnOutOptions& options,
                                         const Points& moved,
                                         const std::vector<bool>& locked,
                                         TriangleSoup* rest);

}  // namespace musclewarp
