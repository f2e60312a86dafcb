// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/joints/found_joint.h"
#include "musclewarp/joints/limb.h"

namespace musclewarp {

// The joints of an arm. Their coordinates are 0 in the pose of the scan, in
// which the arm is taken to hang or lie beside the body. Preconditions
// (CHECKed): the limb has the bones that are named.

// Finds a shoulder: a sphere on the head of the humerus. Its axes are those of
// the image, as the scapula does not tell them (humerus).
FoundJoint FindShoulder(const Limb& limb);

// Finds an elbow: the axis of the surface of revolution of the humerus that
// looks at the ulna and, if it is there, the radius (humerus, ulna).
FoundJoint FindElbow(const Limb& limb);

// Finds the joint about which the radius turns about the ulna: the line from
// the head of the ulna at the wrist to the head of the radius at the elbow
// (humerus, ulna, radius).
FoundJoint FindForearm(const Limb& limb);

}  // namespace musclewarp
