// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/even_remeshing.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <glog/logging.h>

#include "musclewarp/cgal/cgal_mesh.h"

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
  // All faces are remeshed, and those that are kept have fixed edges: CGAL 5.5
  // may fail where only a part of the faces is remeshed (out_of_range).
  auto is_fixed =
      mesh.add_property_map<CgalMesh::Edge_index, bool>("e:is_fixed", false)
          .first;
  for (const CgalMesh::Face_index face : mesh.faces()) {
    // Faces have the numbers of the triangles.
    if (is_kept.empty() || !is_kept[face]) continue;
    for (const auto edge : halfedges_around_face(mesh.halfedge(face), mesh)) {
      // CGAL refuses longer ones.
      is_fixed[mesh.edge(edge)] =
          pmp::edge_length(edge, mesh) <= 4.0 / 3 * edge_length;
    }
  }
  pmp::isotropic_remeshing(mesh.faces(),
                           edge_length,
                           mesh,
                           pmp::parameters::number_of_iterations(kIterations)
                               .edge_is_constrained_map(is_fixed)
                               .protect_constraints(true));
  return FromCgalMesh(mesh);
}

}  // namespace musclewarp
