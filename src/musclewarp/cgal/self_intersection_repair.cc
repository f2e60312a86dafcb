// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/self_intersection_repair.h"

#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>

#include "musclewarp/cgal/cgal_mesh.h"

namespace musclewarp {

TriangleSoup WithSelfIntersectionsRepaired(const TriangleSoup& soup,
                                           const std::vector<int>& triangles) {
  CgalMesh mesh = ToCgalMesh(soup);
  // Faces have the numbers of the triangles.
  std::vector<CgalMesh::Face_index> faces;
  for (const int f : triangles) faces.emplace_back(f);
  CGAL::Polygon_mesh_processing::experimental::remove_self_intersections(faces,
                                                                         mesh);
  return FromCgalMesh(mesh);
}

}  // namespace musclewarp
