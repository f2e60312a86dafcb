// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The largest absolute value of a coordinate in a scene, mm: 10 km. No part of
// a body is that far from the origin of its frame, even in the frame of a gait
// laboratory or after an hour of simulated walking, whereas coordinates in
// other units or damaged numbers often are. Up to this limit, doubles are
// spaced at most 2e-9 mm apart, and no product of coordinates overflows.
constexpr double kLargestCoordinate = 1e7;

// Returns "allowed: -1e7 to 1e7 mm", the advice in messages about coordinates.
std::string AllowedCoordinates();

// Throws InputError if a coordinate of `points` (#P x 3, in units of
// `body_size` mm, Scene::body_size) is not finite or exceeds kLargestCoordinate
// in magnitude. `where` names the file and the field; the message adds the
// index of the point, counted from 0, and its position.
void CheckCoordinates(const std::string& where,
                      const Points& points,
                      double body_size = 1);

// Checks the translation of a rigid motion (mm) in the same way, and that its
// rotation is finite.
void CheckCoordinates(const std::string& where,
                      const Eigen::Matrix4d& transform);

}  // namespace musclewarp
