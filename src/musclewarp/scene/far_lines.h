// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Warnings about lines of a muscle that are far off its mesh, as they are if
// the two were made in different frames or units: one sentence for each line
// with a point farther from every vertex than five times the diagonal of the
// mesh, which names the farthest point (counted from 0) and its distance. A
// tendon is not that long: that of the plantaris, the longest beside its belly,
// is about four times as long. `points` are those of the mesh (#V x 3, mm, rest
// pose); precondition (CHECKed): there is one. Lengths are in units of
// `body_size` mm (Scene::body_size).
std::vector<std::string> FarLineWarnings(const SceneMuscle& muscle,
                                         const Points& points,
                                         double body_size = 1);

}  // namespace musclewarp
