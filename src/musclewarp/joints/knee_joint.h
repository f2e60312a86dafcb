// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/found_joint.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// Finds a knee: a cylinder on both posterior condyles. The coordinate is 0
// where femur and tibia are in line, as seen along the axis. The verdict is by
// the signs of docs/joints.md. Precondition (CHECKed): the limb has a tibia.
FoundJoint FindKnee(const Limb& limb, const FemurShape& femur);

}  // namespace musclewarp
