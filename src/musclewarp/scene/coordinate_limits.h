// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The largest size that a coordinate of a scene may have, mm: 10 km. Nothing of
// a body is that far from the origin of its frame, even in the frame of a
// gait laboratory or with a model that has walked for an hour, whereas a file
// in other units or a damaged number often is. Within the limit a double still
// tells places 2e-9 mm apart, and no product of coordinates overflows.
constexpr double kLargestCoordinate = 1e7;

// "allowed: -1e7 to 1e7 mm": the advice of messages about coordinates.
std::string AllowedCoordinates();

// Throws InputError if a coordinate of `points` (#P x 3, in units of
// `body_size` mm, Scene::body_size) is not finite or larger than
// kLargestCoordinate. `where` names the file and the field; the message adds
// the index of the point, counted from 0, and its place.
void CheckCoordinates(const std::string& where,
                      const Points& points,
                      double body_size = 1);

// The same for the translation of a rigid motion (mm), and for its rotation,
// which must be finite.
void CheckCoordinates(const std::string& where,
                      const Eigen::Matrix4d& transform);

}  // namespace musclewarp
