// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/found_joint.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// Finds the path of a patella. It glides on a circle about an axis parallel to
// that of the knee, which is fitted to the groove of the femur that it glides
// in. Its lower tip keeps its distance from the tuberosity of the tibia, as the
// patellar ligament hardly stretches: so its coordinate follows that of the
// knee (FoundJoint::coupling), and is 0 in the pose of the scan.
//
// `knee` is the joint of the same side; without one there is no path.
// Precondition (CHECKed): the limb has a femur, a patella and a tibia.
FoundJoint FindPatella(const Limb& limb, const FoundJoint& knee);

}  // namespace musclewarp
