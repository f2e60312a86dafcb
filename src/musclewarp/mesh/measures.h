// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Volume, area and extent of triangle meshes. Muscles keep their volume as they
// deform: SignedVolume is the constrained quantity, VolumeGradient its
// Jacobian.

// Returns the enclosed volume, mm^3,
//
//   V(X) = 1/6 sum over triangles (a, b, c) of (x_a x x_b) . x_c,
//
// paper eq. (2.6). It is positive if the triangles face outward. The sum is the
// enclosed volume for closed meshes only: for others it depends on the origin.
double SignedVolume(const Points& points, const Triangles& triangles);

// Returns true if triangles pass along every edge as often in one direction as
// in the other, but for one where their number is odd, as at a border. If they
// do not, the signs of SignedVolume are mixed, and its value means nothing.
bool IsConsistentlyOriented(const Triangles& triangles);

// Returns dV/dX, #V x 3, mm^2. The row of vertex i is 1/6 sum (x_b x x_c) over
// the triangles (i, b, c) around it; paper eq. (2.10), J_g.
Points VolumeGradient(const Points& points, const Triangles& triangles);

// Returns how VolumeGradient changes while the points move with `velocities`
// (#V x 3, mm by some unit), #V x 3, mm^2 by that unit: the Hessian of the
// volume times the velocities.
Points VolumeGradientRate(const Points& points,
                          const Points& velocities,
                          const Triangles& triangles);

// Returns the sum of the areas of all triangles, mm^2.
double SurfaceArea(const Points& points, const Triangles& triangles);

// Returns the integral of the mean curvature over a closed surface, mm: half
// the sum over its edges of length times the angle between the normals of both
// triangles, positive where it is convex (Steiner's formula). Edges of more or
// fewer than two triangles do not count.
double MeanCurvatureIntegral(const Points& points, const Triangles& triangles);

// Returns a third of the area of the triangles at each vertex, #V, mm^2.
Eigen::VectorXd VertexAreas(const Points& points, const Triangles& triangles);

// Returns the edge of equilateral triangles that are as many as those of a mesh
// and have the same area, mm: what its edges would measure if they were even.
double TypicalEdge(const Points& points, const Triangles& triangles);

// Returns the length of the diagonal of the axis-aligned bounding box of all
// points, used by triangles or not, mm; 0 if there are no points.
double BoundingBoxDiagonal(const Points& points);

}  // namespace musclewarp
