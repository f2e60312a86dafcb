// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

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

// Copies the parts of a scene for Python.
template <typename Part>
std::vector<std::shared_ptr<Part>> Shared(const std::vector<Part>& parts) {
  std::vector<std::shared_ptr<Part>> shared;
  for (const Part& part : parts) shared.push_back(std::make_shared<Part>(part));
  return shared;
}

}  // namespace musclewarp::python
