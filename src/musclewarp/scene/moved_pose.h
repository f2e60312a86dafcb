// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/scene/scene_pose.h"

namespace musclewarp {

// Returns a pose moved by a rigid motion: what was there is here, and
// everything is to everything else as it was.
ScenePose MovedPose(ScenePose pose, const Eigen::Matrix4d& here_from_there);

}  // namespace musclewarp
