// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/scene_pose.h"

namespace musclewarp {

// Indices of the poses that `frames` selects, rising: "all", "last", "7",
// "first:last" or "first:last:step", both ends included. Ends may be times
// ("0.1s"): from the first pose not before to the last not after. Throws
// InputError naming --frames.
std::vector<int> SelectFrames(const std::string& frames,
                              const std::vector<ScenePose>& poses);

}  // namespace musclewarp
