// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/self_intersection_repair.h"

#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>

#include "musclewarp/cgal/cgal_mesh.h"

namespace musclewarp {

TriangleSoup WithSelfIntersectionsRepaired(const TriangleSoup& soup) {
  CgalMesh mesh = ToCgalMesh(soup);
  CGAL::Polygon_mesh_processing::experimental::remove_self_intersections(mesh);
  return FromCgalMesh(mesh);
}

}  // namespace musclewarp
