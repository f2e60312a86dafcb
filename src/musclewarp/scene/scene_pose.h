// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The points of taut lines (#P x 3, mm) by name, and the positions of the
// bodies for which they were solved.
struct SolvedLines {
  std::map<std::string, Eigen::Matrix4d> bodies;
  std::map<std::string, Points> points;
};

// One pose of a scene: the positions of its bodies and lines.
struct ScenePose {
  std::string name;
  double time = 0;  // s

  // Values of coordinates by name: as in the file of the poses, or in degrees
  // and m for poses of a model. They are displayed and recorded, but move
  // nothing.
  std::map<std::string, double> coordinates;

  // The transform target_from_rest of each body by name, mm. A body that is not
  // named does not move.
  std::map<std::string, Eigen::Matrix4d> bodies;

  // Target points (#P x 3, mm) of each line by name. A line that is not named
  // moves with its bodies.
  std::map<std::string, Points> lines;

  // Taut lines, once they were solved (WithTautLines): they count only as long
  // as `bodies` are those for which they were.
  SolvedLines taut_lines;

  // How bones push the free shapes of muscles aside (bone_push.h): by muscle,
  // the displacements of its coarse vertices, N x 3, mm, from where it is
  // without. Those that no bone pushes are not named.
  std::map<std::string, Points> pushes;

  // Only for poses of an OpenSim model: the values of all its coordinates (rad
  // or m), and the lengths (mm) of the lines that are paths of its muscles,
  // straight through all active points.
  std::vector<double> model_values;
  std::map<std::string, double> path_lengths;
};

}  // namespace musclewarp
