// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/anatomy/bone.h"
#include "musclewarp/joints/found_joint.h"

namespace musclewarp {

// Returns the size of a skeleton relative to a human one, by the lengths of its
// long and flat bones: 1 for a person of any size, cut or not; else the nearest
// power of two of its ratio to an adult, such as 1/32 for a mouse. Returns 1
// also if no bone tells the size, and for skeletons smaller than any animal, so
// that meshes in metres are noticed.
double SkeletonSizeOf(const std::vector<Bone>& bones);

// Multiplies the lengths of a joint and of its shapes. Sentences stay.
void ScaleLengths(double factor, FoundJoint* joint);

}  // namespace musclewarp
