// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/remeshing.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <glog/logging.h>

#include "musclewarp/geometry/cgal_mesh.h"

namespace musclewarp {

TriangleSoup Remeshed(const TriangleSoup& soup,
                      double edge_length,
                      const std::vector<bool>& is_kept) {
  CHECK_GT(edge_length, 0);
  CHECK(is_kept.empty() ||
        static_cast<Eigen::Index>(is_kept.size()) == soup.triangles.rows());
  constexpr int kIterations = 5;
  namespace pmp = CGAL::Polygon_mesh_processing;
  CgalMesh mesh = ToCgalMesh(soup);
  std::vector<CgalMesh::Face_index> faces;
  for (const CgalMesh::Face_index face : mesh.faces()) {
    // Faces have the numbers of the triangles.
    if (is_kept.empty() || !is_kept[face]) faces.push_back(face);
  }
  pmp::isotropic_remeshing(faces,
                           edge_length,
                           mesh,
                           pmp::parameters::number_of_iterations(kIterations));
  return FromCgalMesh(mesh);
}

}  // namespace musclewarp
