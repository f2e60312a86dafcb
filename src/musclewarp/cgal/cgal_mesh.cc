// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/cgal_mesh.h"

#include <glog/logging.h>

#include <vector>

namespace musclewarp {

CgalMesh ToCgalMesh(const TriangleSoup& soup) {
  CgalMesh mesh;
  std::vector<CgalMesh::Vertex_index> vertices;
  for (const auto p : soup.points.rowwise()) {
    vertices.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  }
  for (const auto t : soup.triangles.rowwise()) {
    const auto face =
        mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    CHECK(face != CgalMesh::null_face()) << "the mesh is not a manifold";
  }
  return mesh;
}

TriangleSoup FromCgalMesh(const CgalMesh& mesh) {
  TriangleSoup soup;
  soup.points.resize(mesh.number_of_vertices(), 3);
  soup.triangles.resize(mesh.number_of_faces(), 3);
  std::vector<int> number(mesh.num_vertices());
  int count = 0;
  for (const auto vertex : mesh.vertices()) {
    const CgalKernel::Point_3& p = mesh.point(vertex);
    soup.points.row(count) << p.x(), p.y(), p.z();
    number[vertex] = count++;
  }
  int f = 0;
  for (const auto face : mesh.faces()) {
    int corner = 0;
    for (const auto vertex :
         CGAL::vertices_around_face(mesh.halfedge(face), mesh)) {
      soup.triangles(f, corner++) = number[vertex];
    }
    ++f;
  }
  return soup;
}

}  // namespace musclewarp
