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
// BindModel finds out how they lie on the model; from then on PoseAt gives the
// scene in any pose of the model.
struct ModelPoses {
  Model model;

  // The coordinates of the rest pose, and where the ground is there in the
  // frame of the meshes (mm).
  CoordinateValues rest;
  Eigen::Matrix4d scene_from_ground;

  // For each body of the model, how it takes points of the meshes into its own
  // frame (mm).
  std::vector<Eigen::Matrix4d> body_from_rest;

  // Indices into the model: of the bodies that the scene uses, of the muscles
  // whose paths are lines of the scene, of the coordinates that the motion
  // gives, and of those among them that change.
  std::vector<int> bodies;
  std::vector<int> muscles;
  std::vector<int> given_coordinates;
  std::vector<int> moving_coordinates;

  // The unit of the lengths of poses, mm (Scene::body_size). All fields above
  // are in mm.
  double body_size = 1;
};

// Where a scene's meshes are on the model, as its scene file says.
struct ModelRest {
  // Coordinates that are not at their defaults, rad or m, by name. Without
  // them the pose is found in which the frames of the bodies coincide.
  std::optional<std::map<std::string, double>> coordinates;

  // The body in whose frame the meshes are; empty for the ground.
  std::string frame;
};

// Puts the meshes of a scene on a model. `bodies` are those that the scene
// uses; the frame of the first is that of the meshes if the rest pose has to be
// found. What was found is told in `notes`, to which it is appended. Throws
// InputError, naming `where`, for a body or coordinate that the model lacks,
// bodies whose frames do not coincide in any pose, and a body on a joint that
// is not supported.
ModelPoses BindModel(Model model,
                     const ModelRest& rest,
                     const std::vector<std::string>& bodies,
                     const std::string& where,
                     std::vector<std::string>* notes);

// Returns the path of a muscle of the model, by its index, as a line of the
// scene in the rest pose. It has all points of the path; conditional points,
// which come and go with the pose, do so gradually (GuidingPath).
ActionLine LineOfMuscle(const ModelPoses& poses, int muscle);

// Returns the bodies and lines of the scene at some values of the model's
// coordinates (rad or m), to which couplers must have been applied. Lengths are
// in units of `body_size`.
ScenePose PoseAt(const ModelPoses& poses, const CoordinateValues& values);

}  // namespace musclewarp
