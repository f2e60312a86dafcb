// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_repair/border_stitching.h"
#include "musclewarp/mesh_repair/hole_filling.h"
#include "musclewarp/mesh_repair/piece_selection.h"
#include "musclewarp/mesh_repair/pull_apart.h"
#include "musclewarp/mesh_repair/sheet_separation.h"
#include "musclewarp/mesh_repair/soup_cleaning.h"

namespace musclewarp {

// How far RepairMesh may go.
struct RepairOptions {
  // Points closer than this are one point, as a share of the diagonal of the
  // bounding box.
  double merge_tolerance = 1e-9;

  // The widest crack between two borders that is stitched, mm.
  double stitch_tolerance = 0.3;

  // The unit of lengths, mm (Scene::body_size), for messages.
  double body_size = 1;

  // Which pieces stay.
  PieceOptions pieces;

  // Which holes may be filled: those with a short border, and slits of any
  // length (see HoleLimits for the exact rule).
  HoleLimits holes;

  // Returns true if all fields are within their ranges; otherwise sets *error
  // to a sentence that names the field, its value and what is allowed.
  bool IsValid(std::string* error) const;
};

// What was done, in the order in which it was done; all zero for a clean mesh.
struct RepairReport {
  PointMerges point_merges;
  // Triangles that were removed.
  int degenerate_triangles = 0;
  int duplicate_triangles = 0;
  // Triangles that were turned round.
  int flipped_triangles = 0;
  // Cuts at non-manifold edges, stitches of cracks, fillings of holes.
  Separation separation;
  Stitches stitches;
  Fillings fillings;
  // Points that were doubled where a body touches itself in a point.
  int separated_vertices = 0;

  // The number of pieces that stay, and those that were dropped.
  int pieces = 1;
  std::vector<DroppedPiece> dropped_pieces;

  // Points that no triangle uses any more, merged ones included.
  int dropped_points = 0;
  // Points that were moved off one another.
  Pulls pulls;

  // True if the mesh was changed in any way.
  bool AnythingDone() const;
};

// Makes closed, outward oriented 2-manifolds out of a mesh as segmentation
// delivers it: one or, with PieceRule::kAll, any number. The steps are: merge
// duplicate points, remove degenerate and duplicate triangles, orient the
// triangles, cut non-manifold edges apart, stitch cracks, drop crumbs, fill
// holes, cut non-manifold vertices apart, and keep what is a surface of the
// mesh. CountDefects(result).IsCleanInPieces() holds, and IsClean() of one
// piece.
//
//   RepairReport report;
//   const TriangleSoup clean = RepairMesh(
//       ReadTriangleSoup(path), path, RepairOptions(), &report);
//   if (report.AnythingDone()) LOG(INFO) << path << " was repaired";
//
// A clean mesh is returned bit by bit as it is. Points and triangles that stay
// keep their order, and points beside no defect keep their place.
// Self-intersections, and pieces that cross each other, are neither looked for
// nor removed. A piece that is connected to the rest by cracks only must face
// the same way as the rest to be stitched to it.
//
// Throws InputError if a hole beyond the limits or a surface with one side
// remains; the message has `name` as its place and says what is wrong and where
// on the mesh. `report` may be null.
// Precondition (CHECKed): the options are valid.
TriangleSoup RepairMesh(const TriangleSoup& soup,
                        const std::string& name,
                        const RepairOptions& options,
                        RepairReport* report);

}  // namespace musclewarp
