// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/geometry/triangle_bvh.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The generalized winding number (Jacobson et al. 2013, "Robust Inside-Outside
// Segmentation"): the sum of the solid angles of all triangles seen from a
// point, over 4 pi. It is 1 inside and 0 outside a closed outward mesh, and
// something between for open ones; points inside have more than 1/2.
//
// The triangles and a fan over the border close each other up. What such a
// closed surface gives is an integer, counted exactly along a ray, so only the
// fan is left to sum: nothing for closed meshes, and no approximation for the
// others. A query costs one ray through the tree and one solid angle for each
// border edge.
//
//   const TriangleBvh bvh(points, triangles);
//   const WindingNumber winding(&bvh, triangles);
//   if (winding.IsInside(p)) ...
class WindingNumber {
 public:
  // `bvh` is the tree of `triangles` and must outlive this; when it is refitted
  // to moved points, this follows.
  WindingNumber(const TriangleBvh* bvh, const Triangles& triangles);

  // Up to rounding for meshes with a border, else exact. On the surface, one of
  // the values beside.
  double At(const Eigen::RowVector3d& point) const;

  // The winding number is above 1/2 and the point not on the surface.
  bool IsInside(const Eigen::RowVector3d& point) const;

  bool IsOnSurface(const Eigen::RowVector3d& point) const;

  // No border: every edge is run in both directions equally often.
  bool IsClosed() const { return border_.empty(); }

 private:
  struct HalfEdge {
    int triangle;
    int corner;  // where it starts
  };
  // Triangles from an apex to all border edges, seen from a point.
  struct Fan {
    int crossings = 0;        // of the ray
    double turns = 0;         // solid angles over 4 pi
    double conditioning = 1;  // of the worst of them
  };
  Fan FanFrom(const Eigen::RowVector3d& apex,
              const Eigen::RowVector3d& point) const;
  Fan BorderFan(const Eigen::RowVector3d& point) const;

  const TriangleBvh* bvh_;
  std::vector<HalfEdge> border_;
};

}  // namespace musclewarp
