// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/deformer/solver_configuration.h"
#include "tools/deform_command.h"

namespace musclewarp {

// The flags that musclewarp-deform and musclewarp-compare have in common:
// scene, frames, preparation and contact. Defined by the program that links
// this.
DeformOptions SceneOptionsFromFlags();

// --max_iterations, for those who want to wait longer.
void SetIterationLimit(SolverConfiguration* configuration);

}  // namespace musclewarp
