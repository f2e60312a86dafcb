// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/mesh.h"

#include <glog/logging.h>

namespace musclewarp {

Mesh MeshFromSoup(const TriangleSoup& soup) {
  Mesh mesh;
  mesh.reserve(
      soup.points.rows(), soup.triangles.rows() * 3 / 2, soup.triangles.rows());
  for (Eigen::Index v = 0; v < soup.points.rows(); ++v) {
    mesh.add_vertex(Mesh::Point(soup.points.row(v).data()));
  }
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const auto face = mesh.add_face(Mesh::VertexHandle(soup.triangles(f, 0)),
                                    Mesh::VertexHandle(soup.triangles(f, 1)),
                                    Mesh::VertexHandle(soup.triangles(f, 2)));
    CHECK(face.is_valid()) << "triangle " << f << " is not manifold";
  }
  return mesh;
}

TriangleSoup SoupFromMesh(const Mesh& mesh) {
  TriangleSoup soup;
  soup.points.resize(mesh.n_vertices(), 3);
  soup.triangles.resize(mesh.n_faces(), 3);
  for (const auto v : mesh.vertices()) {
    soup.points.row(v.idx()) =
        Eigen::Map<const Eigen::RowVector3d>(mesh.point(v).data());
  }
  for (const auto f : mesh.faces()) {
    int corner = 0;
    for (const auto v : f.vertices()) {
      soup.triangles(f.idx(), corner++) = v.idx();
    }
  }
  return soup;
}

}  // namespace musclewarp
