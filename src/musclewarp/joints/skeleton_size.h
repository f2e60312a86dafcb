// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/joints/bone.h"
#include "musclewarp/joints/found_joint.h"

namespace musclewarp {

// Returns how large a skeleton is against a human one, by the lengths of its
// long and flat bones: 1 for that of a person of any size, cut or not, and else
// the power of two by which it is nearest to that of an adult: 1/32 for a
// mouse. 1 also where nothing can be told, and for what no animal is as small
// as, so that meshes in metres are noticed.
double SkeletonSizeOf(const std::vector<Bone>& bones);

// Multiplies the lengths of a joint and of its shapes. Sentences stay.
void ScaleLengths(double factor, FoundJoint* joint);

}  // namespace musclewarp
