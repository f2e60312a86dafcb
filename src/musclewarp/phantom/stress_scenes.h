// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/phantom/phantom_scene.h"

namespace musclewarp {

// Small scenes, each of which is hard on contact in one respect:
//
//   stress_attachment  Three muscles share one area of attachment and are
//                      10 mm into each other there.
//   stress_edge        A muscle is pulled across an edge of 60 degrees of a
//                      bone.
//   stress_plate       A bone plate of 1 mm is between two muscles, both of
//                      which reach through it.
//   stress_resolution  Three muscles with edges of 6, 2 and 0.6 mm are 6 mm
//                      into each other.
//   stress_sheet       A thin sheet of muscle is between two bones that come
//                      nearer and slide.
//   stress_sweep       A bone sweeps 150 degrees past a muscle, 6 mm into it.
//
// docs/results.md has what comes of them.

// Returns the names above.
std::vector<std::string> StressSceneNames();

// Makes the scene of that name; `seed` decides on the bumps of the meshes.
// Precondition (CHECKed): `name` is one of StressSceneNames().
PhantomScene MakeStressScene(const std::string& name, uint32_t seed);

}  // namespace musclewarp
