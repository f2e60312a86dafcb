// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// Values of all coordinates of a model, in its order; rad, or m.
using CoordinateValues = std::vector<double>;

// The defaults, with couplers applied.
CoordinateValues DefaultValues(const Model& model);

// Sets the coordinates that are functions of others.
void ApplyCouplers(const Model& model, CoordinateValues* values);

// Throws InputError if the motion of a body or path is not known: a joint on
// its way to the ground, or one of its functions, is not supported, or there is
// no joint. `used_by` says who needs it.
void CheckBodyIsSupported(const Model& model,
                          int body,
                          const std::string& used_by);
void CheckMuscleIsSupported(const Model& model, int muscle);

// ground_from_body of every body, mm. Those that are not supported are where
// their parents are.
std::vector<Eigen::Matrix4d> BodyFrames(const Model& model,
                                        const CoordinateValues& values);

// Where a path point is on its body, mm.
Eigen::Vector3d LocationOnBody(const PathPoint& point,
                               const CoordinateValues& values);

// Whether a path point is part of the path.
bool IsActive(const PathPoint& point, const CoordinateValues& values);

// Length of the path straight through its active points, mm.
double PathLength(const ModelMuscle& muscle,
                  const std::vector<Eigen::Matrix4d>& body_frames,
                  const CoordinateValues& values);

// -dl/dq of the straight path by central differences, mm a unit of the
// coordinate (mm/rad, or mm/m), couplers moving along. Where a condition
// switches a point within the step, the side without the switch is taken.
double PathMomentArm(const Model& model,
                     const ModelMuscle& muscle,
                     int coordinate,
                     const CoordinateValues& values);

// True if the body moves with the coordinate, or with one coupled to it.
bool MovesBody(const Model& model, int coordinate, int body);

}  // namespace musclewarp
