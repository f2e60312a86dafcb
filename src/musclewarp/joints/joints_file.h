// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/joints/articulation.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

// Returns the report of an articulation, joints.json (docs/joints.md): lengths
// in mm in the frame of the bones, angles in degrees.
nlohmann::ordered_json JointsJson(const Articulation& articulation,
                                  const std::string& axes);

// Reads joints that a user gives in the same form, of which only "joints" is
// needed, and of each joint "name", "center_mm", and "axis" or "parent_axes"
// (and "child_axes", if coordinates are not 0 in the pose of the scan). "axis"
// is the direction of the axis of a hinge, as its coordinate turns about it.
// Joints that failed are passed over. Lengths may be in another unit, if
// "units" says so.
//
// Throws InputError, which names the file and the field, for what is missing or
// not allowed: a name that is no joint, axes that are no rotation, a joint
// given twice.
std::vector<FoundJoint> ReadJoints(const std::string& path);
std::vector<FoundJoint> ReadJoints(const JsonField& file);

}  // namespace musclewarp
