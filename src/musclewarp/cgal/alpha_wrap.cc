// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/alpha_wrap.h"

#include <CGAL/alpha_wrap_3.h>
#include <glog/logging.h>

#include <array>
#include <vector>

#include "musclewarp/cgal/cgal_mesh.h"

namespace musclewarp {

TriangleSoup AlphaWrap(const TriangleSoup& soup, double alpha, double offset) {
  CHECK_GT(soup.triangles.rows(), 0);
  CHECK(alpha > 0 && offset > 0) << alpha << " " << offset;
  std::vector<CgalKernel::Point_3> points;
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    points.emplace_back(
        soup.points(i, 0), soup.points(i, 1), soup.points(i, 2));
  }
  std::vector<std::array<int, 3>> faces;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    faces.push_back(
        {soup.triangles(f, 0), soup.triangles(f, 1), soup.triangles(f, 2)});
  }
  CgalMesh wrap;
  CGAL::alpha_wrap_3(points, faces, alpha, offset, wrap);
  return FromCgalMesh(wrap);
}

}  // namespace musclewarp
