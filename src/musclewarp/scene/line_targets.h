// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns the transform target_from_rest of a body in a pose (mm), or the
// identity if the pose does not name the body.
Eigen::Matrix4d BodyTransform(const ScenePose& pose, const std::string& body);

// Returns the targets of the lines of a muscle in a pose, one for each line:
// the target points that the pose gives, or else the rest points moved with
// their bodies, or else the rest points. The inner points of a sliding line
// also move with the bodies of neighbouring points, and are then distributed
// along the line as at rest. If a line names bodies, its target also has their
// rotations, for the twist of the muscle about the line. Points are #P x 3, mm.
std::vector<LineTarget> LineTargets(const std::vector<ActionLine>& lines,
                                    const ScenePose& pose);

}  // namespace musclewarp
