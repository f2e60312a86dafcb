// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Multiplies all lengths of a prepared scene by a factor above 0, areas by its
// square and volumes by its cube: in meshes, hulls, lines, attachments and
// records of repairs. The rows of energies do not change, as only solvers use
// them: a scaled model must not be solved. Sentences do not change either.
// Scaling by a power of two is exact.
void ScaleLengths(double factor, PreparedScene* scene);

}  // namespace musclewarp
