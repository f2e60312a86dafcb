// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_repair/repair.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// One of the closed surfaces that a mesh consists of.
struct MusclePiece {
  std::string name;
  TriangleSoup mesh;  // mm, closed, outward oriented
  double volume = 0;  // mm^3
};

// A mesh taken apart.
struct MusclePieces {
  std::vector<MusclePiece> pieces;  // the largest volume first
  RepairReport repairs;             // with the pieces left out

  // Remarks of the reader for the user.
  std::vector<std::string> notes;
};

// Reads the mesh of a muscle, repairs it with PieceRule::kAll, and splits it
// into its pieces. Pieces are named after the named parts of the file
// (mesh_parts.h) that contain them: "gluteus_medius", or "gluteus_1",
// "gluteus_2", largest first, if several have the same name. If the file has no
// names, or a piece belongs to parts of different names, all pieces are named
// after the muscle in the same way.
//
// Throws InputError as ReadTriangleSoup, CheckMuscleSize and RepairMesh do.
// Precondition (CHECKed): the options are valid.
MusclePieces PiecesOfMuscle(const SceneMuscle& muscle, RepairOptions options);

}  // namespace musclewarp
