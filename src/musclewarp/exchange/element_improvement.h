// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/exchange/tetrahedral_mesh.h"

namespace musclewarp {

// Improves tetrahedra with a dihedral angle below `goal_deg`, as meshers leave
// them where all triangles of a surface must stay: by exchanging the
// tetrahedra around an edge or beside a face, by moving points inside and by
// adding some (Freitag and Ollivier-Gooch 1997, "Tetrahedral mesh improvement
// using swapping and smoothing"; Klingner and Shewchuk 2007, "Aggressive
// tetrahedral mesh improvement"). A change is made only if the smallest angle
// among the tetrahedra that it concerns grows, so that no angle below the
// smallest one arises, and the mesh stays free of inverted elements if it was.
//
// The first `surface_points` points of the mesh stay as they are, and so do the
// faces of its border. Points inside are numbered anew.
void ImproveElements(double goal_deg,
                     Eigen::Index surface_points,
                     TetrahedralMesh* mesh);

}  // namespace musclewarp
