// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// A pose in which the frames of several bodies coincide. In models that were
// made from a scan by giving every body the frame of the scanner, this is the
// pose of the scan, and so the rest pose of its meshes.
struct CoincidentPose {
  CoordinateValues values;

  // How well the frames coincide: the largest distance between the origin of
  // the first body and that of another one (mm), and the largest angle between
  // their frames (rad).
  double distance = 0;
  double angle = 0;
};

// Finds the pose in which the frames of `bodies` coincide best, by least
// squares over the coordinates that move some of the bodies relative to others.
// The solver starts from the default values, which other coordinates keep;
// coupled ones follow. Whether the frames do coincide is for the caller to
// judge from the result. Precondition (CHECKed): there is a body.
CoincidentPose FindCoincidentPose(const Model& model,
                                  const std::vector<int>& bodies);

}  // namespace musclewarp
