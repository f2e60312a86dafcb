// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Planes that cut a mesh.
struct SectionPlanes {
  Points places;   // a point of each plane, #S x 3, mm
  Points normals;  // #S x 3, of any length above 0
};

// Returns the area (mm^2) of the section of a closed surface (#V x 3, #F x 3,
// mm) by the plane through `place` at right angles to `normal`. If the plane
// cuts the surface in several pieces, as it does a muscle that bends around a
// bone, the piece counts that `place` is in, or else the nearest one. Cavities
// do not count. It is 0 if the plane misses the surface. Preconditions: the
// surface is a closed manifold, oriented outward; `normal` is not zero.
double SectionArea(const Points& points,
                   const Triangles& triangles,
                   const Eigen::RowVector3d& place,
                   const Eigen::RowVector3d& normal);

// Returns the largest SectionArea by any of the planes, mm^2, 0 without planes.
double LargestSectionArea(const Points& points,
                          const Triangles& triangles,
                          const SectionPlanes& planes);

}  // namespace musclewarp
