// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The vertex indices of tetrahedra, #T x 4, counted from zero. The first three
// corners run counterclockwise seen from the fourth one, so that the volume is
// positive: the order of Abaqus, FEBio, Gmsh and VTK.
using Tetrahedra = Eigen::Matrix<int, Eigen::Dynamic, 4, Eigen::RowMajor>;

struct TetrahedralMesh {
  Points points;  // #V x 3, mm
  Tetrahedra tetrahedra;
};

// Returns the signed volumes of the tetrahedra, #T, mm^3: negative for those
// that are inverted.
Eigen::VectorXd Volumes(const TetrahedralMesh& mesh);

// An angle that finite elements should not fall below, degrees.
constexpr double kSmallDihedralDeg = 10;

// How well a mesh is fit for finite elements.
struct ElementQuality {
  double smallest_dihedral_deg = 0;  // of all edges; 70.5 in a regular one
  double largest_dihedral_deg = 0;

  // The longest edge over the radius of the inscribed sphere, divided by that
  // of a regular tetrahedron: 1 is best.
  double largest_aspect = 0;

  // Tetrahedra with a dihedral angle below kSmallDihedralDeg, and those of them
  // with a corner where the surface is sharp (sharp_points.h).
  int small_angles = 0;
  int small_angles_at_sharp = 0;

  int inverted = 0;   // tetrahedra whose volume is not positive
  double volume = 0;  // of all, mm^3
};

// Measures a mesh. `is_sharp` tells of its first points, those of the surface,
// whether the surface is sharp there; it may be empty. Precondition (CHECKed):
// there are tetrahedra.
ElementQuality QualityOf(const TetrahedralMesh& mesh,
                         const std::vector<bool>& is_sharp = {});

// The four faces of a tetrahedron, outward, in the order of the faces of
// Abaqus: the corners 1 2 3, 1 4 2, 2 4 3, 3 4 1.
constexpr int kFaceCorners[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

// A face of a tetrahedron.
struct ElementFace {
  int tetrahedron = -1;
  int face = -1;  // row of kFaceCorners
};

// Returns for each triangle of a surface (#F x 3, indices of the points of the
// mesh) the face that it is, if the triangles are exactly the border of the
// tetrahedra; an empty list if they are not, because triangles were split or
// lost, or because there are tetrahedra elsewhere.
std::vector<ElementFace> BorderFaces(const Tetrahedra& tetrahedra,
                                     const Triangles& surface);

}  // namespace musclewarp
