// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/scene_pose.h"

namespace musclewarp {

// Returns the indices of the poses that the text of --frames selects, in rising
// order: "all", "last", "7", "first:last" or "first:last:step", both ends
// included. An end may be a time ("0.1s"), which stands for the first pose that
// is not before it, or the last that is not after it. Throws InputError naming
// --frames if the text is none of these or selects no pose.
std::vector<int> SelectFrames(const std::string& frames,
                              const std::vector<ScenePose>& poses);

// The same for poses with numbers of their own, rising, as the frames of a run
// have those of their folders: N, FIRST, LAST and STEP are about these numbers.
// Ranges take what is there between numbers that the run spans. Returns indices
// of the poses.
std::vector<int> SelectFrames(const std::string& frames,
                              const std::vector<ScenePose>& poses,
                              const std::vector<int>& numbers);

}  // namespace musclewarp
