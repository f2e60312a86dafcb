// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "musclewarp/scene/scene.h"

namespace musclewarp::phantom {

// A point of a line that moves on its body with flexion, straight from its rest
// place to `flexed` (in the frame of the body, mm) at 60 degrees.
struct WrappedPoint {
  std::string line;
  int point = 0;
  Eigen::Vector3d flexed;
};

// The OpenSim model (.osim, version 4) of the embedded hip: pelvis and femur in
// the frame of the scene, between them a joint of three rotations at
// `hip_centre` (mm), and the lines of the muscles as paths.
std::string HipModelText(const Scene& scene,
                         const Eigen::Vector3d& hip_centre,
                         const WrappedPoint& wrapped);

// A motion for it (.mot): flexion from -10 to 60 degrees, 15 rows in 0.7 s.
std::string HipMotionText();

}  // namespace musclewarp::phantom
