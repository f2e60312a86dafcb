// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// One pose of a scene: where its bodies and its lines are.
struct ScenePose {
  std::string name;
  double time = 0;  // s

  // Values of coordinates by their names, as the file of the poses has them, or
  // of a model in degrees and m. They are shown and recorded; nothing moves by
  // them.
  std::map<std::string, double> coordinates;

  // target_from_rest of each body by its name, mm. A body that is not named
  // stays.
  std::map<std::string, Eigen::Matrix4d> bodies;

  // Target points (#P x 3, mm) of each line by its name. A line that is not
  // named moves with its bodies.
  std::map<std::string, Points> lines;

  // Only for poses of an OpenSim model: the values of all its coordinates (rad
  // or m), and for the lines that are paths of its muscles the length (mm)
  // straight through all points that are active.
  std::vector<double> model_values;
  std::map<std::string, double> path_lengths;
};

}  // namespace musclewarp
