// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh_repair/repair.h"

namespace musclewarp {

// Returns a sentence for each piece that the repair of a mesh has left out,
// with its volume, share and position, and one sentence for all crumbs. Flaps
// without volume and with a share of the surface below 1e-4 are ignored.
// Lengths are in units of `body_size` mm (Scene::body_size).
std::vector<std::string> DroppedPieceWarnings(const std::string& name,
                                              const RepairReport& repairs,
                                              double body_size = 1);

}  // namespace musclewarp
