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
// one pose of the model, their rest pose, and in the frame that one body has
// there. BindModel finds the transforms between the meshes and the model;
// PoseAt then returns the scene in any pose of the model.
struct ModelPoses {
  Model model;

  // The model coordinates of the rest pose (rad or m), and the transform from
  // the ground to the frame of the meshes in it (mm).
  CoordinateValues rest;
  Eigen::Matrix4d scene_from_ground;

  // For each body of the model, the transform from the meshes in the rest pose
  // to the frame of the body (mm).
  std::vector<Eigen::Matrix4d> body_from_rest;

  // Indices into the model: the bodies that the scene uses, the muscles whose
  // paths are lines of the scene, the coordinates in the motion, and those of
  // these coordinates that change.
  std::vector<int> bodies;
  std::vector<int> muscles;
  std::vector<int> given_coordinates;
  std::vector<int> moving_coordinates;

  // The unit of length of poses, mm (Scene::body_size). All fields above are in
  // mm.
  double body_size = 1;
};

// The placement of a scene's meshes on the model, as its scene file states it.
struct ModelRest {
  // Coordinates that differ from their defaults, rad or m, by name. Without
  // them, BindModel searches for the pose in which the frames of the bodies
  // coincide.
  std::optional<std::map<std::string, double>> coordinates;

  // The body in whose frame the meshes were made; empty for the ground.
  std::string frame;
};

// Places the meshes of a scene on a model. `bodies` are the bodies that the
// scene uses. If the rest pose is unknown and has to be found, the meshes are
// in the frame of the first body, and a sentence about the result is appended
// to `notes`. Throws InputError, naming `where`, for a body or coordinate that
// the model lacks, for bodies whose frames do not coincide in any pose, and for
// a body on an unsupported joint.
ModelPoses BindModel(Model model,
                     const ModelRest& rest,
                     const std::vector<std::string>& bodies,
                     const std::string& where,
                     std::vector<std::string>* notes);

// Returns the path of a muscle of the model, by its index, as a line of the
// scene in the rest pose (#P x 3, mm). It has all points of the path;
// conditional points, which are active in some poses only, appear and disappear
// gradually (GuidingPath).
ActionLine LineOfMuscle(const ModelPoses& poses, int muscle);

// Returns the bodies and lines of the scene at given values of the model's
// coordinates (rad or m), to which couplers must have been applied. Lengths are
// in units of `body_size` mm.
ScenePose PoseAt(const ModelPoses& poses, const CoordinateValues& values);

}  // namespace musclewarp
