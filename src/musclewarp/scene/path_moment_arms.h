// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/scene/perturbed_poses.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns the length of a line in a pose, mm: the sum of its straight segments.
// If the line is the path of a muscle of the model, it passes through all
// points that are active in the pose, including conditional ones.
double PathLengthIn(const ScenePose& pose, const ActionLine& line);

// Returns the moment arms of all lines of a scene with a model in a pose, by
// line and coordinate: -dl/dq of the length l (PathLengthIn), in mm/rad, or
// mm/m for a translational coordinate. They are central differences over
// `beside`, the poses on both sides of `pose` (PerturbedPosesOf).
std::map<std::string, std::map<std::string, double>> PathMomentArms(
    const Scene& scene,
    const ScenePose& pose,
    const std::vector<PerturbedPoses>& beside);

}  // namespace musclewarp
