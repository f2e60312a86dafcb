// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/contact_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "musclewarp/geometry/mesh_intersection.h"

namespace musclewarp {

ContactMesh ContactMesh::Of(const Points& rest,
                            const Triangles& triangles,
                            double volume) {
  using Eigen::RowVector3d;
  // Bounds of a weight: needles must not stiffen what is around them.
  constexpr double kLeast = 1e-2, kMost = 1e2;
  ContactMesh mesh;
  mesh.triangles = triangles;
  mesh.volume = volume;
  mesh.tree = std::make_shared<TriangleBvh>(rest, triangles);
  mesh.self_pairs = static_cast<int>(SelfIntersections(*mesh.tree).size());
  mesh.areas = Eigen::VectorXd::Zero(rest.rows());
  std::vector<std::map<int, double>> around(rest.rows());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const RowVector3d a = rest.row(triangles(f, 0));
    const RowVector3d u = rest.row(triangles(f, 1)) - a;
    const RowVector3d v = rest.row(triangles(f, 2)) - a;
    const double area = u.cross(v).norm() / 2;
    for (int k = 0; k < 3; ++k) {
      const int i = triangles(f, k);
      const int j = triangles(f, (k + 1) % 3);
      const double square = (rest.row(i) - rest.row(j)).squaredNorm();
      const double weight = square > 0 ? 2.0 / 3 * area / square : kMost;
      around[i][j] += weight;
      around[j][i] += weight;
      mesh.areas[i] += area / 3;
    }
  }
  mesh.first.push_back(0);
  for (const auto& edges : around) {
    for (const auto& [neighbour, weight] : edges) {
      mesh.neighbours.push_back(neighbour);
      mesh.weights.push_back(std::clamp(weight, kLeast, kMost));
    }
    mesh.first.push_back(static_cast<int>(mesh.neighbours.size()));
  }
  return mesh;
}

}  // namespace musclewarp
