// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "musclewarp/scene/scene.h"

namespace musclewarp::phantom {

// A point of an action line that slides on its body with flexion, as a muscle
// does that bends over a bone: straight from its rest place at 0 degrees to
// `flexed` (mm, in the frame of the body) at 60 degrees.
struct WrappedPoint {
  // The name of the line, and the index of the point on it.
  std::string line;
  int point = 0;
  Eigen::Vector3d flexed;
};

// Returns the OpenSim model (.osim, version 4) of the embedded hip: pelvis and
// femur, whose frames are that of the scene at rest, a joint of three rotations
// about `hip_centre` (mm) between them, and the lines of the muscles as paths.
std::string HipModelText(const Scene& scene,
                         const Eigen::Vector3d& hip_centre,
                         const WrappedPoint& wrapped);

// Returns a motion of that model (.mot): flexion from -10 to 60 degrees in 15
// rows, 0.7 s.
std::string HipMotionText();

}  // namespace musclewarp::phantom
