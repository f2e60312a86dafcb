// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/deformer/solver_configuration.h"
#include "tools/deform_command.h"

namespace musclewarp {

// Returns the options of a run as the flags set them that musclewarp-deform and
// musclewarp-compare have in common: scene, frames, preparation and contact.
// Linking this file defines these flags. The values are not checked here but by
// CheckSceneOptions, except for texts that have to be parsed, for which this
// throws InputError naming the flag.
DeformOptions SceneOptionsFromFlags();

// Returns those of these flags that were set but --frames, one a line, for
// --flagfile. Scene and data are named by whole paths, so that the file may be
// used from anywhere.
std::string SceneFlagFile();

// Returns what the same flags say about the model of a scene. Throws InputError
// that names the flag, also for a folder that is not there.
ModelSources ModelSourcesFromFlags();

// Sets the limits of all solvers of a configuration to --max_iterations, for
// those who want to wait longer. Throws InputError if it is below 1.
void SetIterationLimit(SolverConfiguration* configuration);

}  // namespace musclewarp
