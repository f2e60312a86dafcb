// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/scene/perturbed_poses.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns the lengths of the lines of a muscle in a pose, mm: the sums of their
// straight segments. A line that is the path of a muscle of the model passes
// through all points that are active in the pose, including conditional ones.
std::vector<double> PathLengthsIn(const ScenePose& pose,
                                  const std::vector<ActionLine>& lines);

// Returns the moment arms of all lines of a scene with a model in a pose, by
// line and coordinate: -dl/dq of the length l (PathLengthsIn), in mm/rad, or
// mm/m for a translational coordinate. They are central differences over
// `beside`, the poses on both sides of `pose` (PerturbedPosesOf).
std::map<std::string, std::map<std::string, double>> PathMomentArms(
    const Scene& scene,
    const ScenePose& pose,
    const std::vector<PerturbedPoses>& beside);

}  // namespace musclewarp
