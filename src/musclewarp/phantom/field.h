// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace musclewarp::phantom {

// A solid as a scalar field over space (mm): negative inside, zero on the
// surface, and growing by about one per millimetre outside, although it need
// not be the exact distance. Simple solids are combined by the smooth operators
// below into organic ones; PolygonizeField makes a mesh of the result.
//
//   const Field bone = Union(Sphere({0, 0, 40}, 12),
//                            Sweep({{{0, 0, 0}, 8}, {{0, 0, 40}, 7}}),
//                            6);
using Field = std::function<double(const Eigen::Vector3d&)>;

// The minimum and the maximum of two values, with the edge between them rounded
// over `width` mm by a quadratic polynomial. The results differ from the sharp
// ones by at most width / 4, the minimum downwards and the maximum upwards.
double SmoothMin(double a, double b, double width);
double SmoothMax(double a, double b, double width);

// Rises smoothly (cubic polynomial) from 0 at `low` to 1 at `high`, and is
// constant outside.
double SmoothStep(double low, double high, double value);

// A ball.
Field Sphere(const Eigen::Vector3d& centre, double radius);

// An ellipsoid with the half axes `radii` along x, y, z.
Field Ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii);

// The points with normal . p < offset; `normal` need not have unit length.
Field HalfSpace(const Eigen::Vector3d& normal, double offset);

// A control point of a sweep: centre and radius, mm.
struct SweepNode {
  Eigen::Vector3d centre;
  double radius;
};

// A round tube along the Catmull-Rom curve through the nodes, with round ends;
// the radius is interpolated like the centre. Precondition: there are at least
// two nodes.
Field Sweep(const std::vector<SweepNode>& nodes);

// What is in a or in b, and what is in both, with edges rounded over `width`
// mm.
Field Union(Field a, Field b, double width);
Field Intersection(Field a, Field b, double width);

// What is in a but not in b, with edges rounded in the same way.
Field Difference(Field a, Field b, double width);

// The solid grown by `distance` mm on all sides, or shrunk if it is negative.
Field Offset(Field field, double distance);

// The solid with its surface moved in and out by at most `amplitude` mm in
// bumps of about `wavelength` mm, as segmentation leaves them. The bumps depend
// on the seed through an integer hash, so they are the same on every machine.
Field Rough(Field field, double amplitude, double wavelength, uint32_t seed);

}  // namespace musclewarp::phantom
