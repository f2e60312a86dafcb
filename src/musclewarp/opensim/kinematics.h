// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// The functions below place the bodies and muscle paths of a model for given
// coordinates, and measure the paths. They check nothing: call
// CheckBodyIsSupported or CheckMuscleIsSupported once for what is needed.

// The values of all coordinates of a model, in its order. Rotational ones are
// in rad, translational ones in m.
using CoordinateValues = std::vector<double>;

// Returns the default values of the coordinates, with couplers applied.
CoordinateValues DefaultValues(const Model& model);

// Sets the coordinates that are functions of others to their values. A chain of
// couplers is followed, whatever their order.
void ApplyCouplers(const Model& model, CoordinateValues* values);

// Returns the coordinates that can change on their own: those that are neither
// locked nor a function of others.
std::vector<int> FreeCoordinates(const Model& model);

// Throws InputError if the motion of a body is not known. This is so if a joint
// on its way to the ground is missing or not supported. `used_by` says in the
// message who needs the body, such as "the scene".
void CheckBodyIsSupported(const Model& model,
                          int body,
                          const std::string& used_by);

// Throws InputError if a path point of the muscle, or the motion of a body on
// which one sits, is not supported.
void CheckMuscleIsSupported(const Model& model, int muscle);

// Returns the transform ground_from_body of every body, 4 x 4, mm. Bodies whose
// joint is not supported have the frames of their parents.
std::vector<Eigen::Matrix4d> BodyFrames(const Model& model,
                                        const CoordinateValues& values);

// Returns the location of a path point in the frame of its body, mm.
Eigen::Vector3d LocationOnBody(const PathPoint& point,
                               const CoordinateValues& values);

// Returns true if a path point is part of the path at these values, as
// conditional points are only for a range of a coordinate.
bool IsActive(const PathPoint& point, const CoordinateValues& values);

// Returns the active points of a path in the ground frame, #points x 3, mm.
// `body_frames` is the result of BodyFrames for the same values.
Points PathPoints(const ModelMuscle& muscle,
                  const std::vector<Eigen::Matrix4d>& body_frames,
                  const CoordinateValues& values);

// Returns the length (mm) of the polyline through the active points of a path,
// or the value of its length function if it has one.
// Wrapping surfaces are ignored. `body_frames` is the result of BodyFrames for
// the same values.
double PathLength(const ModelMuscle& muscle,
                  const std::vector<Eigen::Matrix4d>& body_frames,
                  const CoordinateValues& values);

// Returns the moment arm -dl/dq of a muscle about a coordinate q, where l is
// the length of its path: in mm (per rad) for rotational coordinates and in mm
// per m for translational ones. The derivative is taken by central differences
// with coupled coordinates moving along. If a condition switches a point on or
// off within the step, the difference is taken on the side without the switch.
double PathMomentArm(const Model& model,
                     const ModelMuscle& muscle,
                     int coordinate,
                     const CoordinateValues& values);

// Returns true if the body moves relative to the ground with the coordinate, or
// with one that is coupled to it.
bool MovesBody(const Model& model, int coordinate, int body);

}  // namespace musclewarp
