// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/found_joint.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// Finds a hip: a sphere on the head of the femur, against which the socket is
// checked. Without a frame of the pelvis that of the image stands in. Without
// the frames of both bones the coordinates are 0 in the pose of the scan. The
// verdict is by the signs of docs/joints.md. Precondition (CHECKed): the limb
// has a hip bone or a pelvis.
FoundJoint FindHip(const Limb& limb, const FemurShape& femur);

}  // namespace musclewarp
