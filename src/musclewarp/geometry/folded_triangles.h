// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A triangle that a deformation folded over.
struct FoldedTriangle {
  int triangle;

  // Of the surroundings of the triangle, from the rest pose, for columns.
  Eigen::Matrix3d rotation;
};

// Returns the triangles that a deformation folded over, in ascending order. A
// fold leaves no trace in the volume and need not make triangles cross, but it
// ruins the surface for rendering and for later use.
//
// A triangle counts as folded if its normal points against its rest normal
// after that was turned by the rotation of its surroundings. This rotation is
// the best fit (Kabsch 1976) to the vertices of the triangle and their
// neighbours up to two edges away, so that a single folded triangle does not
// turn its own reference. Triangles that are too thin for their normal to be
// more than rounding error do not count.
//
// `rest` and `deformed` are the positions of the same vertices (#V x 3), and
// `triangles` is #F x 3.
std::vector<FoldedTriangle> FoldedTriangles(const Points& rest,
                                            const Points& deformed,
                                            const Triangles& triangles);

}  // namespace musclewarp
