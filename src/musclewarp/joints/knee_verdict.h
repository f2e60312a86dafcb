// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/found_joint.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// Judges the knee of a femur by KneeLimits. The surface to which the cylinder
// was fitted may not be condyles at all, as on the upper part of a femur.
// Precondition (CHECKed): a knee was fitted.
JointVerdict JudgeKnee(const FemurShape& femur);

}  // namespace musclewarp
