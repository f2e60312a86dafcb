// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/phantom/field.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp::phantom {

// Lines, attachments and motions of made-up scenes. All results are rounded so
// that they are the same on every machine.

// The middle of the longest stretch of the line (., y, z) inside the field,
// within 200 mm of x = 0. Precondition (CHECKed): there is one.
double MiddleAlongX(const Field& field, double y, double z);

// `count` of the points that `is_in` accepts, far from each other: each next
// one is the farthest from those taken, the first is the first accepted.
// Precondition (CHECKed): there are so many.
Points SpreadPoints(const Points& points,
                    const std::function<bool(const Eigen::Vector3d&)>& is_in,
                    int count);

// target_from_rest of a turn about an axis (unit length) through `centre`, by
// the right-hand rule.
Eigen::Matrix4d RotationAbout(const Eigen::Vector3d& centre,
                              const Eigen::Vector3d& axis,
                              double degrees);

// The points of the line moved with their bodies; a body that is not named
// stays.
Points MovedLine(const ActionLine& line,
                 const std::map<std::string, Eigen::Matrix4d>& bodies);

}  // namespace musclewarp::phantom
