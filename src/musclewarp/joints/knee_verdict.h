// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/found_joint.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// Judges the knee of a femur by the signs of docs/joints.md: the condyles that
// a cylinder was fitted to may be none, as on the upper part of a femur.
// Precondition (CHECKed): a knee was fitted.
JointVerdict JudgeKnee(const FemurShape& femur);

}  // namespace musclewarp
