// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns poses on the way from rest, which the first one is, to a pose, which
// is the last one, evenly spread: a function of the pose alone, not of the
// motion that it is part of. They are as PoseBetween() has them, seen from the
// first body in use, which in all of them is where it is in `pose`. So whatever
// moves everything has no part in the way. There are more of them the farther
// the pose is from rest, one more for each 20 degrees of turn or 40 mm of a
// point of a line, and at most 24 more. Taut lines are solved
// (WithTautLines).
std::vector<ScenePose> WayFromRest(const Scene& scene, const ScenePose& pose);

}  // namespace musclewarp
