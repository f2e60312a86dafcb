// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// One instant of the motion.
struct ScenePose {
  std::string name;
  double time = 0;                            // s
  std::map<std::string, double> coordinates;  // for the record only
  // target_from_rest, mm; a body that is not named stays.
  std::map<std::string, Eigen::Matrix4d> bodies;
  // Target points by line name; a line that is not named moves with its bodies.
  std::map<std::string, Points> lines;

  // Of poses of an OpenSim model, the values of all its coordinates, and for
  // the lines that are paths of its muscles the length straight through all
  // points that are active, mm.
  std::vector<double> model_values;
  std::map<std::string, double> path_lengths;
};

}  // namespace musclewarp
