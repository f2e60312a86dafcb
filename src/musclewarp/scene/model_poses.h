// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// An OpenSim model as the source of a scene's poses. The meshes were made in
// one pose of the model, their rest pose, and in the frame of one body there.
struct ModelPoses {
  Model model;
  CoordinateValues rest;
  Eigen::Matrix4d scene_from_ground;
  // Where the meshes lie on each body of the model.
  std::vector<Eigen::Matrix4d> body_from_rest;

  std::vector<int> bodies;              // in use by the scene
  std::vector<int> muscles;             // whose paths are lines of the scene
  std::vector<int> given_coordinates;   // by the motion
  std::vector<int> moving_coordinates;  // of these, those that change
};

// Where a scene's meshes are on the model.
struct ModelRest {
  // Coordinates that are not at their defaults, rad or m, by name. Without
  // them the pose is found in which the frames of the bodies coincide.
  std::optional<std::map<std::string, double>> coordinates;
  std::string frame;  // body whose frame the meshes are in; "": the ground
};

// Puts the meshes on the model. `bodies` are those in use, of which the first
// is taken for the frame of a pose that is found. Throws InputError, naming
// `where`: a body or coordinate the model lacks, bodies whose frames do not
// coincide in any pose, a body on a joint that is not supported.
ModelPoses BindModel(Model model,
                     const ModelRest& rest,
                     const std::vector<std::string>& bodies,
                     const std::string& where,
                     std::vector<std::string>* notes);

// The path of a muscle as a line of the scene: its fixed and moving points.
// Conditional points are left out: they come and go with the pose.
ActionLine LineOfMuscle(const ModelPoses& poses, int muscle);

// The bodies and lines in use at some coordinates; couplers must be applied.
ScenePose PoseAt(const ModelPoses& poses, const CoordinateValues& values);

}  // namespace musclewarp
