// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/figures/bone_findings.h"

namespace musclewarp {

// Returns the pairs of bones of two bodies of which one has a vertex in the
// other, in scene order. `bodies`: by bone. Bones of one body lie as they were
// delivered in every pose and are not looked at. Precondition (CHECKed): every
// bone has a body.
std::vector<BoneOverlap> BoneOverlaps(const std::vector<NamedMesh>& bones,
                                      const std::vector<std::string>& bodies);

}  // namespace musclewarp
