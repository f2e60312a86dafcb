// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns a warning for each line that has a point farther from every vertex of
// the mesh than five times the diagonal of the mesh. Such lines and meshes were
// probably made in different frames or units. The warning names the farthest
// point (counted from 0) and its distance. No tendon is that long: the tendon
// of the plantaris, the longest relative to its belly, is about four times as
// long as the belly. `points` are the vertices of the mesh (#V x 3, rest pose);
// precondition (CHECKed): there is at least one. Lengths are in units of
// `body_size` mm (Scene::body_size).
std::vector<std::string> FarLineWarnings(const SceneMuscle& muscle,
                                         const Points& points,
                                         double body_size = 1);

}  // namespace musclewarp
