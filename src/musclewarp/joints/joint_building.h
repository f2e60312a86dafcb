// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "musclewarp/joints/cylinder_fit.h"
#include "musclewarp/joints/found_joint.h"
#include "musclewarp/joints/limb.h"
#include "musclewarp/joints/sphere_fit.h"

namespace musclewarp {

// Helpers of the functions that find joints.

// Returns a joint with the bodies of its table entry and nothing found yet.
FoundJoint StartedJoint(JointKind kind, const Limb& limb);

// Return the description of a fit for the report. `angle` is the angle that the
// surface covers about the axis, rad.
FittedShape ShapeOf(const std::string& what, const SphereFit& fit);
FittedShape ShapeOf(const std::string& what,
                    const Cylinder& cylinder,
                    double spread,
                    double angle);

// Returns right-handed orthonormal axes in columns: column `exact` is along one
// direction, column `near` as close as possible to another one. Precondition:
// the directions are not parallel.
Eigen::Matrix3d AxesAlong(int exact,
                          const Eigen::Vector3d& exact_direction,
                          int near,
                          const Eigen::Vector3d& near_direction);

}  // namespace musclewarp
