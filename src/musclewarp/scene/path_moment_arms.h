// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/scene/perturbed_poses.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns the length of a line in a pose, mm, straight through its points. If
// the line is the path of a muscle of the model, it goes through all points
// that are active in the pose, conditional ones included.
double PathLengthIn(const ScenePose& pose, const ActionLine& line);

// Returns the moment arms of all lines of a scene with a model in a pose, by
// line and coordinate: -dl/dq of the straight length l, in mm/rad, or mm/m of a
// coordinate that is a translation. They are central differences over `beside`,
// the poses on both sides of the pose (PerturbedPosesOf).
std::map<std::string, std::map<std::string, double>> PathMomentArms(
    const Scene& scene,
    const ScenePose& pose,
    const std::vector<PerturbedPoses>& beside);

}  // namespace musclewarp
