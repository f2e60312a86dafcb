// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"

namespace musclewarp {

// A muscle jumps if its largest change from frame to frame is more than so many
// times the median of the motion, and more than so many mm in a human.
constexpr double kJumpRatio = 3;
constexpr double kLeastJump = 1;

// Returns a sentence for everything in the frames that is beyond anatomy, with
// the worst frame and the place: attachment areas that leave their body,
// muscles that are stretched too far, jumps, and bones that lie in each other,
// where frames say so (Frame::bone_overlaps). Frames may be usable
// nevertheless. Jumps are looked for in motions of at least five frames.
// Limits follow the size of the body (Scene::body_size).
std::vector<std::string> ShapeWarnings(const std::vector<FrameFigures>& frames,
                                       double body_size = 1);

}  // namespace musclewarp
