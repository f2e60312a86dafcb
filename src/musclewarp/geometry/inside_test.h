// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/geometry/triangle_grid.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Tells points inside a mesh from those outside by the parity of the crossings
// of a ray in a random direction (Kellnhofer and Kohout, section 3.2). A ray
// that meets an edge or a corner is replaced by another; if a few of them do,
// or if the mesh is not closed, so that parity means nothing, the generalized
// winding number decides. A point on the surface is not inside. Where a closed
// mesh overlaps itself parity rules: what is inside twice is outside.
//
// Queries are const, may run on many threads, and depend on the mesh and the
// seed only.
class InsideTest {
 public:
  // Any soup. The seed chooses the directions.
  InsideTest(const Points& points, const Triangles& triangles, unsigned seed);

  // New positions, same triangles.
  void Refit(const Points& points);

  bool Contains(const Eigen::RowVector3d& point) const;

  // Along a unit direction to the first triangle, mm; infinite if there is
  // none.
  double DistanceAlong(const Eigen::RowVector3d& point,
                       const Eigen::RowVector3d& direction) const {
    return grid_.FirstHit(point, direction);
  }

  // Every edge has an even number of triangles.
  bool IsClosed() const { return is_closed_; }

 private:
  // Made when it is first asked.
  struct Arbiter {
    std::once_flag once;
    std::unique_ptr<SearchableMesh> mesh;
  };
  bool RayContains(const Eigen::RowVector3d& point) const;
  bool WindingContains(const Eigen::RowVector3d& point) const;

  TriangleSoup soup_;
  TriangleGrid grid_;
  unsigned seed_;
  bool is_closed_;
  std::unique_ptr<Arbiter> arbiter_;
  // Of empty cells of the grid, when a point of theirs has been asked for.
  mutable std::vector<std::atomic<char>> cell_sides_;
};

}  // namespace musclewarp
