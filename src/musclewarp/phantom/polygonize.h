// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/phantom/field.h"

namespace musclewarp::phantom {

struct PolygonizeOptions {
  // Edge of the grid cells, mm: about the edge length of the mesh. Where the
  // solid is thinner than a cell's diagonal (1.73 times this) the mesh is still
  // a manifold but may fold.
  double cell = 3;
  // Steps that spread the points evenly along the surface.
  int smoothing_steps = 8;
};

// The zero set of `field` within `box` as a closed mesh, outward oriented,
// points on the surface to about 0.01 mm and then rounded to multiples of
// 2^-10 mm, so that the last bits of a platform's mathematics do not show.
// Surface nets (Gibson 1998, Constrained Elastic Surface Nets) with the
// elastic net pulled back onto the field. Precondition: the field is positive
// on the box and grows by at most 2 per mm.
TriangleSoup PolygonizeField(const Field& field,
                             const Eigen::AlignedBox3d& box,
                             const PolygonizeOptions& options);

// To the nearest multiple of 2^-10 mm.
Eigen::Vector3d RoundedPoint(const Eigen::Vector3d& p);

}  // namespace musclewarp::phantom
