// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/model_poses.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// An area of a body where a muscle is attached: what lies within `radius` mm of
// one of `points` (#P x 3, rest pose, mm).
struct Attachment {
  std::string body;
  Points points;
  double radius = 0;
  // Its triangles may cross bones of the body; they are counted apart.
  bool may_penetrate = false;
};

// A muscle of a scene. Its mesh is given by points and triangles, or named by a
// file.
struct SceneMuscle {
  std::string name;
  Points points;                  // #V x 3, mm; none: read from mesh_path
  Triangles triangles;            // #F x 3
  std::vector<ActionLine> lines;  // none: to be made from the meshes
  std::vector<Attachment> attachments;
  std::string mesh_path;
};

// A bone of a scene, with its mesh as that of a muscle.
struct SceneBone {
  std::string name;
  Points points;        // #V x 3, mm; none: read from mesh_path
  Triangles triangles;  // #F x 3
  std::string body;     // that the bone moves with; empty: named as the bone
  std::string mesh_path;
  // What puts the points of the file into the scene: scale and place of meshes
  // that a model names; the identity for those of the scene file.
  Eigen::Matrix4d rest_from_file = Eigen::Matrix4d::Identity();
};

// Muscles, bones and poses. All positions are in the rest pose, in one frame,
// in millimetres. A scene is read from a file (ReadScene) or put together in
// memory:
//
//   Scene scene;
//   scene.muscles.push_back({"psoas", psoas_points, psoas_triangles, lines});
//   scene.bones.push_back({"femur_r", femur_points, femur_triangles});
struct Scene {
  std::string name;
  std::string path;
  // Where +x, +y, +z point (see geometry/view.h), and the side of the body that
  // "lateral" is on: for those who look at the results.
  std::string axes = "LPS";
  std::string side = "right";
  std::vector<SceneMuscle> muscles;
  std::vector<SceneBone> bones;
  std::vector<ScenePose> poses;
  // The poses follow each other (their times rise): a frame starts from the one
  // before. Else each is on its own.
  bool is_motion = false;
  // Where the poses come from, if that is an OpenSim model; else null.
  std::shared_ptr<const ModelPoses> model;
  std::string motion_path;
  std::vector<std::string> files;  // all that were read, or will be
  // What was passed over, or found, while reading.
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

// Reads a scene file (docs/scene.md), and the model and motion it names. Paths
// in it are relative to `data_root`, or to the folder of the scene file if that
// is empty; `motion`, if not empty, is taken in place of the scene's motion.
// Throws InputError that names the file and the field: not JSON, unknown key,
// missing key, wrong type, duplicate name, a body that nothing names, a line
// with too few or repeated points, rest and target of different length, a
// matrix that is not a rigid motion; and what ReadModel, ReadStorageTable,
// MotionOf and BindModel throw.
Scene ReadScene(const std::string& path,
                const std::string& data_root,
                const std::string& motion = "");

// The pose at a part (0 to 1) of the way from one pose to another: coordinates
// of the model in between. Without a model bodies go along their screw motions,
// and the points of lines with the body of whose motion they have a share, or
// straight.
ScenePose PoseBetween(const Scene& scene,
                      const ScenePose& from,
                      const ScenePose& to,
                      double part);

// The pose the meshes came in.
ScenePose RestPose(const Scene& scene);

}  // namespace musclewarp
