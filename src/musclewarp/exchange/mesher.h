// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "musclewarp/exchange/tetrahedral_mesh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// How a surface is filled with tetrahedra. The mesher is a program of its own,
// which is looked for when it is needed: TetGen (AGPL-3.0) or Gmsh (GPL-2.0 or
// later). Nothing of it is linked.
struct MesherOptions {
  enum class Kind { kTetgen, kGmsh };
  Kind kind = Kind::kTetgen;
  std::string program;     // its path, see FindMesher
  double timeout_s = 600;  // after which it is stopped; above 0

  // The largest ratio of the radius of the circumscribed sphere to the shortest
  // edge that TetGen aims at inside; at least 1.2. Smaller needs more points.
  double radius_edge_ratio = 2;

  // The smallest dihedral angle that ImproveElements() aims at, degrees; 0: the
  // mesh stays as the mesher made it.
  double goal_dihedral_deg = 12;

  // The largest volume of an element of TetGen, mm^3; 0: any. Gmsh goes by the
  // triangles of the surface.
  double max_volume = 0;
};

// What came out: a mesh, or why there is none.
struct MesherResult {
  std::optional<TetrahedralMesh> mesh;
  std::string failure;
};

// Returns the kind and path of a mesher: "tetgen", "gmsh", or the path of one
// of these. Throws InputError that names --mesher if there is no such program.
MesherOptions FindMesher(const std::string& mesher);

// Fills closed surfaces that neither cross nor touch, such as the muscles of a
// frame, with tetrahedra. TetGen fails if they do; Gmsh, which fills each piece
// by itself, may not. All triangles of the surface are faces of the mesh:
// none is split. The points of the mesh begin with those of the surface, bit
// for bit; further ones are inside. Works in a folder of its own below the
// system's folder for temporary files. Throws InputError if that cannot be
// written.
MesherResult FillWithTetrahedra(const TriangleSoup& surface,
                                const MesherOptions& options);

}  // namespace musclewarp
