// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/remeshing.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <glog/logging.h>

#include "musclewarp/geometry/cgal_mesh.h"

namespace musclewarp {

TriangleSoup Remeshed(const TriangleSoup& soup,
                      double edge_length,
                      int iterations) {
  CHECK_GT(edge_length, 0);
  namespace pmp = CGAL::Polygon_mesh_processing;
  CgalMesh mesh = ToCgalMesh(soup);
  pmp::isotropic_remeshing(mesh.faces(),
                           edge_length,
                           mesh,
                           pmp::parameters::number_of_iterations(iterations));
  return FromCgalMesh(mesh);
}

}  // namespace musclewarp
