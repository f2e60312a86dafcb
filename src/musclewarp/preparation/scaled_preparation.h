// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Multiplies all lengths of a prepared scene by a factor above 0, areas and
// volumes by its powers: meshes, hulls, lines, attachments and what is known of
// repairs. The rows of energies are left as they are, as only solvers use them:
// a scaled model must not be solved for. Sentences stay, too. A power of two is
// exact.
void ScaleLengths(double factor, PreparedScene* scene);

}  // namespace musclewarp
