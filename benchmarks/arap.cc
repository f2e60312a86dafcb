// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "arap.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>
#include <glog/logging.h>

namespace musclewarp {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Deformation = CGAL::Surface_mesh_deformation<SurfaceMesh>;

SurfaceMesh MeshFrom(const TriangleSoup& soup) {
  SurfaceMesh mesh;
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    mesh.add_vertex({soup.points(i, 0), soup.points(i, 1), soup.points(i, 2)});
  }
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    mesh.add_face(SurfaceMesh::Vertex_index(soup.triangles(f, 0)),
                  SurfaceMesh::Vertex_index(soup.triangles(f, 1)),
                  SurfaceMesh::Vertex_index(soup.triangles(f, 2)));
  }
  return mesh;
}

}  // namespace

struct Arap::Data {
  explicit Data(const TriangleSoup& soup)
      : mesh(MeshFrom(soup)), deformation(mesh) {}
  SurfaceMesh mesh;
  Deformation deformation;
  std::vector<Handle> handles;
};

Arap::Arap(const TriangleSoup& mesh, const std::vector<Handle>& handles)
    : data_(std::make_unique<Data>(mesh)) {
  data_->handles = handles;
  const auto vertices = data_->mesh.vertices();
  data_->deformation.insert_roi_vertices(vertices.begin(), vertices.end());
  for (const Handle& handle : handles) {
    data_->deformation.insert_control_vertex(
        SurfaceMesh::Vertex_index(handle.vertex));
  }
  CHECK(data_->deformation.preprocess());
}

Arap::~Arap() = default;

Points Arap::Deform(int iterations) {
  data_->deformation.reset();
  for (const Handle& handle : data_->handles) {
    data_->deformation.set_target_position(
        SurfaceMesh::Vertex_index(handle.vertex),
        {handle.target[0], handle.target[1], handle.target[2]});
  }
  data_->deformation.deform(iterations, /*tolerance=*/0);
  Points points(data_->mesh.number_of_vertices(), 3);
  for (const auto vertex : data_->mesh.vertices()) {
    const Kernel::Point_3& p = data_->mesh.point(vertex);
    points.row(vertex) << p.x(), p.y(), p.z();
  }
  return points;
}

}  // namespace musclewarp
