// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/joints/surface_points.h"

namespace musclewarp {

// A straight line in space.
struct Axis {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       // mm
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // of unit length
};

struct Cylinder {
  Axis axis;
  double radius = 0;  // mm
};

// Returns the vector from an axis to a point at right angles to the axis, mm.
Eigen::Vector3d OffsetFrom(const Axis& axis, const Eigen::Vector3d& point);

// Fits a cylinder to points (#P x 3, mm) by minimising the sum of w^2
// rho(distance from the axis - r) with the soft L1 loss of FitSphere, starting
// at `start`. `weights` (#P) are the w. The point of the result is the one of
// its axis that is nearest to the point of the start. Precondition (CHECKed):
// there are at least five points.
Cylinder FitCylinder(const Points& points,
                     const Eigen::VectorXd& weights,
                     const Cylinder& start,
                     double scale);

// Returns the points within `tolerance` (mm) of a cylinder whose normals lie
// along its radii, by at least 32 degrees, and face away from the axis.
SurfacePoints PointsOn(const SurfacePoints& surface,
                       const Cylinder& cylinder,
                       double tolerance);

// Returns the angle about an axis in which there are points (#P x 3, mm),
// rad: sectors of 5 degrees count if they have at least two.
double AngleCovered(const Points& points, const Axis& axis);

// Returns the root mean square of the distances of points from a cylinder, mm;
// 0 without points.
double SpreadAbout(const Cylinder& cylinder, const Points& points);

}  // namespace musclewarp
