// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns target_from_rest of a body in a pose (mm); the identity if the pose
// does not name the body.
Eigen::Matrix4d BodyTransform(const ScenePose& pose, const std::string& body);

// Returns where a pose puts the lines of a muscle, one target for each line: at
// the target points that the pose gives, else at the rest points moved with
// their bodies, else at the rest points. The points between the ends of a line
// that slides move with the bodies of their neighbours too, and are then spread
// along the line as at rest. If a line names bodies, the target has their
// rotations too, for the twist of the muscle about the line.
std::vector<LineTarget> LineTargets(const std::vector<ActionLine>& lines,
                                    const ScenePose& pose);

}  // namespace musclewarp
