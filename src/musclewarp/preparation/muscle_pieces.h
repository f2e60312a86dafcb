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
  RepairReport repairs;             // with what was left out

  // What the reader had to say, for the user.
  std::vector<std::string> notes;
};

// Reads and repairs the mesh of a muscle with PieceRule::kAll, and takes it
// apart. Pieces are called by the named parts of the file (mesh_parts.h) that
// they are: "gluteus_medius", or where several are of one name "gluteus_1",
// "gluteus_2", the largest first. Where there are no such names, or a piece is
// of several, they are called by the muscle in the same way.
//
// Throws InputError for what ReadTriangleSoup, CheckMuscleSize and RepairMesh
// refuse. Precondition (CHECKed): the options are valid.
MusclePieces PiecesOfMuscle(const SceneMuscle& muscle, RepairOptions options);

}  // namespace musclewarp
