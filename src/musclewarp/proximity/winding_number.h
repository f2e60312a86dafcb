// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// Decides whether points are inside a mesh, even if the mesh has holes or
// overlaps itself, by the generalized winding number (Jacobson et al. 2013,
// "Robust Inside-Outside Segmentation using Generalized Winding Numbers"). This
// is the sum of the solid angles under which a point sees the triangles,
// divided by 4 pi. It is 1 inside a closed outward mesh and 0 outside, and
// takes values in between for open meshes. Points with more than 1/2 are
// inside.
//
// The sum is split in two. Together with a fan of triangles over its border the
// mesh is a closed surface, whose winding number is an integer and is counted
// exactly along a ray. Only the solid angles of the fan have to be summed. So
// the result is exact for closed meshes, and it is not an approximation for
// others. A query costs one ray through the tree and one solid angle for each
// border edge.
//
//   const TriangleBvh bvh(points, triangles);
//   const WindingNumber winding(&bvh, triangles);
//   if (winding.IsInside(p)) ...
class WindingNumber {
 public:
  // `bvh` is the tree over `triangles` (#F x 3). It must outlive this object,
  // which follows it when it is refitted to moved points. Precondition
  // (CHECKed): both have the same number of triangles.
  WindingNumber(const TriangleBvh* bvh, const Triangles& triangles);

  // Does the same as `other` with another tree of the same mesh.
  WindingNumber(const TriangleBvh* bvh, const WindingNumber& other)
      : bvh_(bvh), border_(other.border_) {}

  // Returns the winding number at a point. It is exact for closed meshes and
  // correct up to rounding for meshes with a border. On the surface, where it
  // jumps, the result is the value on one of the two sides.
  double At(const Eigen::RowVector3d& point) const;

  // Returns true if the winding number is above 1/2 and the point is not on the
  // surface.
  bool IsInside(const Eigen::RowVector3d& point) const;

  // Returns true if the point lies on a triangle, by an exact test.
  bool IsOnSurface(const Eigen::RowVector3d& point) const;

  // Returns true if the mesh has no border: triangles run along every edge
  // equally often in both directions.
  bool IsClosed() const { return border_.empty(); }

 private:
  // An edge of a triangle, from `corner` to the next one.
  struct HalfEdge {
    int triangle;
    int corner;
  };
  // The fan of triangles from an apex to all border edges, seen from a point.
  struct Fan {
    int crossings = 0;        // with the ray from the point
    double turns = 0;         // sum of the solid angles over 4 pi
    double conditioning = 1;  // of the worst of these
  };
  Fan FanFrom(const Eigen::RowVector3d& apex,
              const Eigen::RowVector3d& point) const;
  Fan BorderFan(const Eigen::RowVector3d& point) const;

  const TriangleBvh* bvh_;
  std::vector<HalfEdge> border_;
};

}  // namespace musclewarp
