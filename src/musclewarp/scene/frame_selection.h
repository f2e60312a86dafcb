// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/scene_pose.h"

namespace musclewarp {

// Returns the indices of the poses that the setting `frames` selects, in
// ascending order: "all", "last", "7", "first:last" or "first:last:step", both
// ends included. An end may be a time ("0.1s"): as the first end it stands for
// the first pose that is not before it, as the last end for the last pose that
// is not after it. "3/8" selects the third of eight parts of the poses, which
// are as alike in number as they can be. Throws InputError, naming {frames}, if
// the text has none of these forms or selects no pose.
std::vector<int> SelectFrames(const std::string& frames,
                              const std::vector<ScenePose>& poses);

// Does the same for poses with numbers of their own, in ascending order, such
// as the numbers of the folders of a run, to which the text then refers. A
// range selects the existing poses within it, and its ends must be within the
// numbers of the run. Returns indices of the poses.
std::vector<int> SelectFrames(const std::string& frames,
                              const std::vector<ScenePose>& poses,
                              const std::vector<int>& numbers);

}  // namespace musclewarp
