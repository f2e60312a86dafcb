// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/joints/articulation.h"

namespace musclewarp {

// Throws InputError, which begins with the name of a bone, if the bone is
// longer than those of any person: it is in another unit.
void CheckBoneSize(const Bone& bone);

// Throws InputError if a joint that was asked for, or every joint, lacks its
// bones. `names` are those of all bones; `lacks_sides` is true if nothing told
// the side of one of them.
void CheckJointsAreThere(const ArticulationOptions& options,
                         const std::vector<std::string>& names,
                         bool lacks_sides,
                         const std::vector<FoundJoint>& joints);

}  // namespace musclewarp
