// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Ways to damage a mesh, for the tests of its repair.

// Appends a point and returns its index.
int AddPoint(const Eigen::RowVector3d& point, TriangleSoup* soup);

void AddTriangle(int a, int b, int c, TriangleSoup* soup);

// Appends the points and triangles of another soup.
void AddSoup(const TriangleSoup& added, TriangleSoup* soup);

// The mean of the corners of triangle f.
Eigen::RowVector3d Middle(const TriangleSoup& soup, int f);

// Removes the triangles whose middle is above z.
void CutOff(double z, TriangleSoup* soup);

// Gives the triangles whose middle is above z points of their own.
void TearOpen(double z, TriangleSoup* soup);

// Splits triangle f alone, and not its neighbour, at a point `beside` the
// middle of its first edge; returns the point.
int AddTJunction(int f, const Eigen::RowVector3d& beside, TriangleSoup* soup);

// A strip of 40 triangles around the z axis that has one side only.
TriangleSoup MoebiusStrip();

}  // namespace musclewarp
