// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The steps of a repair that decide which pieces of a mesh stay: pieces that
// are connected through edges.

// What a mesh may consist of.
enum class PieceRule {
  kLargest,  // one surface: only the piece with the largest area stays
  kAll,      // any number of surfaces: all pieces but debris stay
};

// Why a piece was left out.
enum class DropReason {
  kCrumb,    // it is tiny: debris of a segmentation, or a flap
  kSmaller,  // it is not the largest piece of a mesh that is one surface
  kOpen,     // its border is too long to be filled
  kFlat,     // it encloses no volume
  kShell,    // it lies within another piece: the wall of a cavity
};

// "crumb", "smaller", "open", "flat" or "shell": the text of reports.
std::string ToString(DropReason reason);

// A piece that was left out.
struct DroppedPiece {
  DropReason reason = DropReason::kCrumb;
  int triangles = 0;
  double area = 0;   // mm^2
  double share = 0;  // of the area of all pieces of the mesh

  // The volume that went with it, mm^3 (EnclosedVolume); 0 for a shell, whose
  // cavity is filled.
  double volume = 0;

  // The mean of its triangles by their area, mm.
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();

  // The volume of the cavity that is filled, as a shell is left out that lies
  // within another piece, mm^3; 0 for other pieces.
  double cavity = 0;
};

struct PieceOptions {
  PieceRule rule = PieceRule::kLargest;

  // A piece with less than this share of the area of all pieces is a crumb; of
  // kAll only one whose border is long, as that of a flap is.
  double stray_area = 0.01;

  // With kAll, a piece with less than this share of the area of the largest is
  // a crumb, closed or not.
  double crumb_area = 1e-3;

  // Returns true if all fields are within their ranges; otherwise sets *error
  // to a sentence that names the field, its value and what is allowed.
  bool IsValid(std::string* error) const;
};

// Drops crumbs, and appends them to `dropped`. To be called before holes are
// filled, so that a flap does not become a body. Points stay as they are.
// Preconditions: the options are valid, and triangles consistently oriented.
void DropCrumbs(const PieceOptions& options,
                TriangleSoup* soup,
                std::vector<DroppedPiece>* dropped);

// Drops all pieces that are no surface of the mesh, and appends them to
// `dropped`: by kLargest all but the largest; by kAll those that are open, flat
// or within another one. The largest stays in any case. To be called after
// holes are filled; otherwise as DropCrumbs.
void KeepSurfaces(const PieceOptions& options,
                  TriangleSoup* soup,
                  std::vector<DroppedPiece>* dropped);

// Sums over pieces that were left out.
struct DroppedTotals {
  int triangles = 0;
  double area = 0;          // mm^2
  double largest_area = 0;  // of one piece, mm^2
  double volume = 0;        // mm^3
  double cavity = 0;        // mm^3
};
DroppedTotals TotalsOf(const std::vector<DroppedPiece>& dropped);

}  // namespace musclewarp
