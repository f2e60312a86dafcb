// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// The pose in which the frames of some bodies lie on each other: that of the
// scan, where every body was given the frame of the scanner.
struct CoincidentPose {
  CoordinateValues values;
  // What is left between the frames, at the worst pair with the first body.
  double distance = 0;  // of origins, mm
  double angle = 0;     // rad
};

// Finds it by least squares over the coordinates between the bodies, from the
// defaults; others keep their defaults. Precondition (CHECKed): there is a
// body.
CoincidentPose FindCoincidentPose(const Model& model,
                                  const std::vector<int>& bodies);

}  // namespace musclewarp
