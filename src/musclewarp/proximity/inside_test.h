// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/proximity/triangle_grid.h"

namespace musclewarp {

// Decides whether points are inside a mesh, quickly enough for all vertices of
// a muscle in every iteration.
//
//   const InsideTest bone(points, triangles, /*seed=*/1);
//   if (bone.Contains(vertex)) ...
//
// The test counts how often a ray in a random direction crosses the mesh; the
// point is inside if the number is odd (Kellnhofer and Kohout, section 3.2). A
// ray that meets an edge or a corner is replaced by another one. The
// generalized winding number decides if several rays in turn do so, or if the
// mesh is not closed, since parity means nothing then. A point on the surface
// is not inside. Where a closed mesh overlaps itself, parity counts: a point
// that is inside twice is outside.
//
// Queries are const and may run on many threads. Their results depend on the
// mesh and the seed only.
class InsideTest {
 public:
  // Takes any triangle soup, of which it keeps a copy. The seed chooses the
  // directions of the rays.
  InsideTest(const Points& points, const Triangles& triangles, unsigned seed);

  // Moves the vertices to new positions (#V x 3); the triangles stay the same.
  // Costs as much as the constructor without its search for open edges.
  void Refit(const Points& points);

  // Returns true if the point is strictly inside the mesh.
  bool Contains(const Eigen::RowVector3d& point) const;

  // Returns the distance (mm) from `point` along a direction of unit length to
  // the first triangle, or infinity if there is none.
  double DistanceAlong(const Eigen::RowVector3d& point,
                       const Eigen::RowVector3d& direction) const {
    return grid_.FirstHit(point, direction);
  }

  // Returns true if every edge has an even number of triangles.
  bool IsClosed() const { return is_closed_; }

 private:
  // The mesh with its winding number, built when a query needs it first.
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
  // For every cell of the grid that no triangle touches, whether it is inside,
  // outside, or not known yet: all points of such a cell have the same answer.
  mutable std::vector<std::atomic<char>> cell_sides_;
};

}  // namespace musclewarp
