// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/phantom/phantom_scene.h"

namespace musclewarp {

// Small scenes, each with one thing that is hard on contact:
//   stress_attachment  three muscles on one area, 10 mm into each other
//   stress_edge        a muscle pulled across the edge of a bone
//   stress_sweep       a bone that sweeps 90 degrees past a muscle
//   stress_sheet       a thin sheet of muscle between two bones
//   stress_plate       a muscle with a bone plate of 1 mm through it
//   stress_resolution  a mesh between ten times finer and ten times coarser
//   ones
std::vector<std::string> StressSceneNames();

// Precondition (CHECKed): `name` is one of these.
PhantomScene MakeStressScene(const std::string& name, uint32_t seed);

}  // namespace musclewarp
