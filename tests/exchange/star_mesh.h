// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/exchange/tetrahedral_mesh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Adds the tetrahedra from the point `centre` to all triangles of a surface,
// whose points come first in `mesh` from `first_point` on: a mesh without a
// mesher, for surfaces that are star-shaped about their centre.
inline void AddStar(const Triangles& triangles,
                    int first_point,
                    const Eigen::RowVector3d& centre,
                    TetrahedralMesh* mesh) {
  const auto point = static_cast<int>(mesh->points.rows());
  mesh->points.conservativeResize(point + 1, 3);
  mesh->points.row(point) = centre;
  const Eigen::Index first = mesh->tetrahedra.rows();
  mesh->tetrahedra.conservativeResize(first + triangles.rows(), 4);
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    // Seen from inside, the corners of a triangle run clockwise.
    mesh->tetrahedra.row(first + f) << first_point + triangles(f, 0),
        first_point + triangles(f, 2), first_point + triangles(f, 1), point;
  }
}

// The mesh of a surface about the mean of its points.
inline TetrahedralMesh StarMesh(const TriangleSoup& surface) {
  TetrahedralMesh mesh;
  mesh.points = surface.points;
  AddStar(surface.triangles, 0, surface.points.colwise().mean(), &mesh);
  return mesh;
}

}  // namespace musclewarp
