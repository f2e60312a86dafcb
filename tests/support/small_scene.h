// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// A scene in memory: two spindles side by side along z, 120 mm long, each with
// a line from the bone "pelvis", a ball at their lower ends, to the bone
// "femur" above, and 1 mm between all of them.
Scene SmallScene();

// A pose of it in which the femur has turned about x by an angle, in rad, and
// pushes towards the spindles.
ScenePose FlexedPose(double angle);

}  // namespace musclewarp
