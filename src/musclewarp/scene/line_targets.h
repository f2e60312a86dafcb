// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// target_from_rest of a body in a pose; the identity if the pose leaves it out.
Eigen::Matrix4d BodyTransform(const ScenePose& pose, const std::string& body);

// Where a pose puts the lines of a muscle: the target points it gives, else the
// rest points moved with their bodies, else the rest points.
std::vector<LineTarget> LineTargets(const std::vector<ActionLine>& lines,
                                    const ScenePose& pose);

}  // namespace musclewarp
