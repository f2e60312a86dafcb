// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Small closed meshes, outward oriented, for tests.

// Corners (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1); volume 1/6.
TriangleSoup UnitTetrahedron();

// Centred box with edges of the given lengths, two triangles a face.
TriangleSoup Box(double x, double y, double z);

// An icosahedron subdivided `levels` times, corners on the sphere:
// 10 * 4^levels + 2 vertices.
TriangleSoup Icosphere(double radius, int levels);

// An icosphere stretched along z with half axes (radius, radius, half_length):
// the plainest muscle.
TriangleSoup Spindle(double radius, double half_length, int levels);

// The box [0, nx] x [0, ny] x [0, nz] with a lattice of points a unit apart on
// its sides, so that several vertices of a side may be inside another body.
TriangleSoup LatticeBox(int nx, int ny, int nz);

// Points whose coordinates are spread evenly over [-1, 1], mm; the same for the
// same seed, whatever ran before.
Points RandomPoints(int count, std::uint32_t seed);

inline TriangleSoup MovedBy(TriangleSoup soup, const Eigen::RowVector3d& by) {
  soup.points.rowwise() += by;
  return soup;
}

inline TriangleSoup SphereAt(const Eigen::RowVector3d& centre,
                             double radius,
                             int levels) {
  return MovedBy(Icosphere(radius, levels), centre);
}

// Both in one mesh, with the triangles of `a` first.
TriangleSoup Together(const TriangleSoup& a, const TriangleSoup& b);

}  // namespace musclewarp
