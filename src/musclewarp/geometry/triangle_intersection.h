// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// Exact tests on closed triangles with the coordinates as they are. A triangle
// without area is the segment or point its corners make.

// True if the triangles share at least one point.
bool TrianglesIntersect(const Corners& a, const Corners& b);
bool TrianglesIntersect(const Eigen::RowVector3d& a0,
                        const Eigen::RowVector3d& a1,
                        const Eigen::RowVector3d& a2,
                        const Eigen::RowVector3d& b0,
                        const Eigen::RowVector3d& b1,
                        const Eigen::RowVector3d& b2);

// True if the triangles share a point beyond the corner or edge they have in
// common by equal coordinates: what makes two triangles of one mesh intersect.
// Equal triangles do, unless they have no area.
bool TrianglesIntersectBeyondCommon(const Corners& a, const Corners& b);

// True if p lies on the triangle.
bool IsOnTriangle(const Eigen::RowVector3d& p, const Corners& triangle);

}  // namespace musclewarp
