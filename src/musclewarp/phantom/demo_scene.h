// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Returns where WriteDemoScene() writes the scene file: DIR/scene/motion.json.
std::string DemoScenePath(const std::string& dir);

// Writes the scene that is inside the programs to DIR/scene: a hip with its
// meshes, an OpenSim model and a motion, with the same bytes as data/phantom
// has. For those who have no data yet, or want to see what data look like.
// Throws InputError if the folder cannot be written.
void WriteDemoScene(const std::string& dir);

}  // namespace musclewarp
