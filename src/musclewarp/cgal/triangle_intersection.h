// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle.h"

namespace musclewarp {

// Exact tests of triangles for intersection. A triangle includes its border,
// and its coordinates count exactly as they are stored, so that the answers
// never contradict each other. A triangle without area is the segment or the
// point that its corners span.

// Returns true if the triangles share at least one point. Triangles that touch
// do.
bool TrianglesIntersect(const Corners& a, const Corners& b);
bool TrianglesIntersect(const Eigen::RowVector3d& a0,
                        const Eigen::RowVector3d& a1,
                        const Eigen::RowVector3d& a2,
                        const Eigen::RowVector3d& b0,
                        const Eigen::RowVector3d& b1,
                        const Eigen::RowVector3d& b2);

// Returns true if the triangles share a point beyond the corner or edge that
// they have in common. This is what it means for two triangles of one mesh to
// intersect, since neighbours always share a corner or an edge. Corners are
// common if their coordinates are equal. Two equal triangles intersect, unless
// they have no area.
bool TrianglesIntersectBeyondCommon(const Corners& a, const Corners& b);

// Returns true if p lies on the triangle, including its border.
bool IsOnTriangle(const Eigen::RowVector3d& p, const Corners& triangle);

}  // namespace musclewarp
