// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "musclewarp/exchange/tetrahedral_mesh.h"

namespace musclewarp {

// Moves a mesh of tetrahedra with its surface, so that its elements stay the
// same from frame to frame. The displacement of the points inside is the
// harmonic function (linear elements) that the displacements of the surface
// have inside: smooth, and exact for affine motions, turns included. Elements
// may still be inverted where the surface bends or shears a lot: QualityOf
// counts them.
class HarmonicMover {
 public:
  // Factorises the Laplacian of a mesh, of whose points the first
  // `surface_points` are on the surface. Precondition (CHECKed): no element of
  // the mesh is inverted, and each point has one.
  HarmonicMover(TetrahedralMesh mesh, Eigen::Index surface_points);
  ~HarmonicMover();

  // Returns the mesh when its surface has moved to `surface`, #S x 3, mm.
  TetrahedralMesh MoveTo(const Points& surface) const;

 private:
  struct Factors;
  TetrahedralMesh mesh_;
  std::unique_ptr<Factors> factors_;
};

}  // namespace musclewarp
