// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/solver/bone_push.h"

namespace musclewarp {

// Returns the forces f, along the normals of samples near bones, for which
//
//   1/2 y^T f + sum k phi(b - y),   y = M f
//
// is least: the energy of a push with the distances of the bones linear.
// `response`: M, how the forces move the samples along their normals, symmetric
// and positive semidefinite. `lack`: b, what the samples lack of the distances
// that they keep while nothing gives way, mm. `start`: forces that are nearly
// right, or zero; they only save time.
Eigen::VectorXd LinearPushForces(const BonePush& push,
                                 const Eigen::MatrixXd& response,
                                 const Eigen::VectorXd& lack,
                                 const Eigen::VectorXd& start);

}  // namespace musclewarp
