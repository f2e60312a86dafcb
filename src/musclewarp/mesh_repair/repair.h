// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/mesh/mesh.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_repair/border_stitching.h"
#include "musclewarp/mesh_repair/hole_filling.h"
#include "musclewarp/mesh_repair/pull_apart.h"
#include "musclewarp/mesh_repair/sheet_separation.h"
#include "musclewarp/mesh_repair/soup_cleaning.h"

namespace musclewarp {

struct RepairOptions {
  // Points closer than this are one point, as a share of the diagonal of the
  // bounding box.
  double merge_tolerance = 1e-9;

  // Widest crack between two borders that is stitched, mm.
  double stitch_tolerance = 0.3;

  // Pieces below this share of the whole area are dropped before holes are
  // filled; of the rest the largest is kept.
  double stray_area = 0.01;

  // Which holes may be filled.
  HoleLimits holes;

  // Returns true if all fields are within their ranges; otherwise sets *error
  // to a sentence that names the field, its value and what is allowed.
  bool IsValid(std::string* error) const;
};

// What was done, in the order it was done; all zero for a clean mesh.
struct RepairReport {
  PointMerges point_merges;
  int degenerate_triangles = 0;  // removed
  int duplicate_triangles = 0;   // removed
  int flipped_triangles = 0;
  Separation separation;       // at non-manifold edges
  Stitches stitches;           // of cracks
  Fillings fillings;           // of holes
  int separated_vertices = 0;  // points doubled where a body touches itself

  int dropped_components = 0;  // stray pieces, flaps, other bodies
  int dropped_triangles = 0;
  double dropped_area = 0;          // mm^2
  double largest_dropped_area = 0;  // mm^2

  int dropped_points = 0;  // in no triangle any more, merged ones included
  Pulls pulls;             // points moved off each other

  bool AnythingDone() const;
};

// Makes one closed, outward oriented 2-manifold of what segmentation delivers:
// merges duplicate points, removes degenerate and duplicate triangles, orients,
// cuts non-manifold edges and vertices apart, stitches cracks, fills small
// holes and keeps the largest piece. CountDefects of the result IsClean(). A
// clean soup comes back as it is, bit by bit. Points and triangles that stay
// keep their order, and points beside no defect their place. Self-intersections
// are neither looked for nor removed, and a piece that hangs on cracks alone
// must face the way of the rest to be stitched to it.
//
// Throws InputError, naming `name`, what is wrong and where, if a hole beyond
// the limits or a one-sided surface remains. `report` may be null.
// Precondition (CHECKed): the options are valid.
Mesh RepairMesh(const TriangleSoup& soup,
                const std::string& name,
                const RepairOptions& options,
                RepairReport* report);

}  // namespace musclewarp
