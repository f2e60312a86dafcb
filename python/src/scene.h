// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "musclewarp/scene/scene.h"

namespace musclewarp::python {

// Parts of scenes do not change once they are made.
using SharedMuscle = std::shared_ptr<SceneMuscle>;
using SharedBone = std::shared_ptr<SceneBone>;
using SharedLine = std::shared_ptr<ActionLine>;
using SharedAttachment = std::shared_ptr<Attachment>;
using SharedPose = std::shared_ptr<ScenePose>;

// The scene that a scene of Python (musclewarp/_scene.py) was assembled into.
using SharedScene = std::shared_ptr<Scene>;

}  // namespace musclewarp::python
