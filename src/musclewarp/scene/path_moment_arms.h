// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Length of a line straight through its points in a pose, mm: through all that
// are active if it is the path of a model's muscle.
double PathLengthIn(const ScenePose& pose, const ActionLine& line);

// -dl/dq of the straight length of every line of the scene, by line and
// coordinate, mm/rad (or mm/m), for the coordinates that the motion moves. By
// central differences of the model; empty without one.
std::map<std::string, std::map<std::string, double>> PathMomentArms(
    const Scene& scene, const ScenePose& pose);

}  // namespace musclewarp
