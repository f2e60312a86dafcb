// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/base/random_draws.h"
#include "musclewarp/phantom/random_bones.h"
#include "musclewarp/phantom/random_muscles.h"
#include "musclewarp/scene/scene_pose.h"

namespace musclewarp::phantom {

// Draws a motion of `num_poses` poses, three to five if that is 0, from the
// rest pose on: one or two joints turn by up to 60 degrees each about a drawn
// axis through the joint, and everything beyond them goes along. The motion is
// possible: on the whole way the bones keep 0.5 mm apart, no line becomes
// shorter than 0.6 or longer than 1.5 times its length at rest, none turns by
// more than 90 degrees from a segment to the next, and no point of a line comes
// more than 6 mm deep into a bone. Where a drawn angle is too large for that, a
// smaller one is taken.
//
// A single pose is the last of the motion.
//
// Returns no poses if no turn of 8 degrees or more was found.
std::vector<ScenePose> DrawPoses(const std::vector<RandomBone>& bones,
                                 const std::vector<RandomMuscle>& muscles,
                                 RandomDraws* draws,
                                 int num_poses = 0);

}  // namespace musclewarp::phantom
