// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/mesh_density.h"

#include <glog/logging.h>

#include <array>

#include "musclewarp/geometry/decimation.h"
#include "musclewarp/mesh/connectivity.h"

namespace musclewarp {

TriangleSoup MidpointRefined(const TriangleSoup& mesh) {
  const Triangles& old = mesh.triangles;
  const EdgeUses edges(old);
  const Eigen::Index num_points = mesh.points.rows();
  TriangleSoup refined;
  refined.points.resize(num_points + static_cast<Eigen::Index>(edges.size()),
                        3);
  refined.points.topRows(num_points) = mesh.points;
  std::vector<int> midpoint_of(3 * old.rows());  // by half-edge
  for (size_t e = 0; e < edges.size(); ++e) {
    const int midpoint = static_cast<int>(num_points + e);
    refined.points.row(midpoint) =
        (mesh.points.row(OriginOf(old, edges[e][0])) +
         mesh.points.row(TargetOf(old, edges[e][0]))) /
        2;
    for (const int half_edge : edges[e]) midpoint_of[half_edge] = midpoint;
  }
  refined.triangles.resize(4 * old.rows(), 3);
  for (Eigen::Index f = 0; f < old.rows(); ++f) {
    const std::array<int, 3> mid = {
        midpoint_of[3 * f], midpoint_of[3 * f + 1], midpoint_of[3 * f + 2]};
    refined.triangles.row(4 * f) << old(f, 0), mid[0], mid[2];
    refined.triangles.row(4 * f + 1) << mid[0], old(f, 1), mid[1];
    refined.triangles.row(4 * f + 2) << mid[2], mid[1], old(f, 2);
    refined.triangles.row(4 * f + 3) << mid[0], mid[1], mid[2];
  }
  return refined;
}

bool IsDensity(double density) {
  return density == 0.25 || density == 1 || density == 4 || density == 16;
}

TriangleSoup WithDensity(const TriangleSoup& mesh, double density) {
  CHECK(IsDensity(density)) << density;
  if (density < 1) {
    return Decimated(mesh, {static_cast<int>(mesh.triangles.rows()) / 4}).soup;
  }
  TriangleSoup refined = mesh;
  for (; density > 1; density /= 4) refined = MidpointRefined(refined);
  return refined;
}

}  // namespace musclewarp
