// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace musclewarp::phantom {

// Shapes as scalar fields: negative inside, zero on the surface, growing about
// one per millimetre outside (not an exact distance). Composed with the smooth
// operators below they give organic solids; PolygonizeField makes meshes of
// them.
using Field = std::function<double(const Eigen::Vector3d&)>;

// The minimum and maximum with the edge between them rounded over `width` mm
// (quadratic polynomial); never above, or below, the sharp one by more than
// width / 4.
double SmoothMin(double a, double b, double width);
double SmoothMax(double a, double b, double width);

// Rises smoothly (cubic) from 0 at `low` to 1 at `high`.
double SmoothStep(double low, double high, double value);

Field Sphere(const Eigen::Vector3d& centre, double radius);

// Half axes along x, y, z.
Field Ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii);

// The points with normal . p < offset; `normal` need not have unit length.
Field HalfSpace(const Eigen::Vector3d& normal, double offset);

// A control point of a sweep: centre and radius, mm.
struct SweepNode {
  Eigen::Vector3d centre;
  double radius;
};

// A round tube along the Catmull-Rom curve through the nodes, radius
// interpolated the same way, ends round. At least two nodes.
Field Sweep(const std::vector<SweepNode>& nodes);

Field Union(Field a, Field b, double width);
Field Intersection(Field a, Field b, double width);

// a without b.
Field Difference(Field a, Field b, double width);

// Grown by `distance` mm on all sides (shrunk if negative).
Field Offset(Field field, double distance);

// The field with its surface moved in and out by at most `amplitude` mm in
// bumps of about `wavelength` mm, as segmentation leaves them. Bumps depend on
// the seed by an integer hash only.
Field Rough(Field field, double amplitude, double wavelength, uint32_t seed);

}  // namespace musclewarp::phantom
