// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/solver/muscle_target.h"

namespace musclewarp {

// Returns a pose with the pushes of bones on all muscles (ScenePose::pushes),
// of which TargetOf() takes account. They are found along the way from rest
// (WayFromRest), so that they depend on the pose alone. Muscles that carry
// others come first, as what they carry goes along.
ScenePose WithPushes(const PreparedScene& scene,
                     const PreRotationOptions& pre_rotation,
                     ScenePose pose);

}  // namespace musclewarp
