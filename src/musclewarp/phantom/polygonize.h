// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/phantom/field.h"

namespace musclewarp::phantom {

// How fine and how even the mesh of a solid is.
struct PolygonizeOptions {
  // The edge of the grid cells, mm, which is about the edge length of the mesh.
  // Where the solid is thinner than the diagonal of a cell (1.73 times this)
  // the mesh is still a manifold but may fold.
  double cell = 3;
  // The number of steps that spread the points evenly along the surface.
  int smoothing_steps = 8;
};

// Returns the zero set of `field` within `box` as a closed, outward oriented
// mesh. Its points lie on the surface to about 0.01 mm before they are rounded
// (see RoundedPoint). The method is that of surface nets (Gibson 1998,
// "Constrained Elastic Surface Nets"), with the elastic net pulled back onto
// the field. Preconditions: the field is positive on the boundary of the box
// and grows by at most 2 per mm.
TriangleSoup PolygonizeField(const Field& field,
                             const Eigen::AlignedBox3d& box,
                             const PolygonizeOptions& options);

// Returns the point rounded to multiples of 2^-10 mm, so that mathematics that
// differs in its last bits from platform to platform gives the same file.
Eigen::Vector3d RoundedPoint(const Eigen::Vector3d& p);

}  // namespace musclewarp::phantom
