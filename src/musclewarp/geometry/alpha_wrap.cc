// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/alpha_wrap.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <glog/logging.h>

#include <array>
#include <vector>

namespace musclewarp {

TriangleSoup AlphaWrap(const TriangleSoup& soup, double alpha, double offset) {
  CHECK_GT(soup.triangles.rows(), 0);
  CHECK(alpha > 0 && offset > 0) << alpha << " " << offset;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> points;
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    points.emplace_back(
        soup.points(i, 0), soup.points(i, 1), soup.points(i, 2));
  }
  std::vector<std::array<int, 3>> faces;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    faces.push_back(
        {soup.triangles(f, 0), soup.triangles(f, 1), soup.triangles(f, 2)});
  }
  CGAL::Surface_mesh<Kernel::Point_3> wrap;
  CGAL::alpha_wrap_3(points, faces, alpha, offset, wrap);

  TriangleSoup result;
  result.points.resize(wrap.number_of_vertices(), 3);
  result.triangles.resize(wrap.number_of_faces(), 3);
  std::vector<int> number(wrap.num_vertices());
  int count = 0;
  for (const auto vertex : wrap.vertices()) {
    const Kernel::Point_3& p = wrap.point(vertex);
    result.points.row(count) << p.x(), p.y(), p.z();
    number[vertex] = count++;
  }
  int f = 0;
  for (const auto face : wrap.faces()) {
    int corner = 0;
    for (const auto vertex :
         CGAL::vertices_around_face(wrap.halfedge(face), wrap)) {
      result.triangles(f, corner++) = number[vertex];
    }
    ++f;
  }
  return result;
}

}  // namespace musclewarp
