// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/found_joint.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// Finds an ankle: a cylinder on the dome of the talus. The coordinate is 0 in
// the pose of the scan. Without a talus of its own the mesh of the foot has it.
// Precondition (CHECKed): the limb has a tibia, and a talus or a foot.
FoundJoint FindAnkle(const Limb& limb, const FemurShape& femur);

// Finds a subtalar joint: spheres on the head of the talus and on its facet
// above the heel bone; 0 in the pose of the scan. Precondition (CHECKed): the
// limb has a tibia and a talus.
FoundJoint FindSubtalar(const Limb& limb, const FemurShape& femur);

}  // namespace musclewarp
