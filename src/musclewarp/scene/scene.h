// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/model_poses.h"
#include "musclewarp/scene/model_sources.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// An area where a muscle is attached to a body: what of the muscle lies within
// `radius` (mm) of one of `points` (#P x 3, mm, rest pose).
struct Attachment {
  std::string body;

  // The muscle to which it is attached instead of to a body, or empty. Such
  // attachments are found, not named by scenes.
  std::string soft_part;

  Points points;
  double radius = 0;

  // If true, the points go round the area, in order, and what is inside belongs
  // to it where it lies within `radius` of the body's bones.
  bool is_outline = false;

  // If true, triangles of the area may cross bones of the body. They are
  // counted apart.
  bool may_penetrate = false;
};

// The name of what an attachment moves with: its body or its soft part.
inline const std::string& NameOfCarrier(const Attachment& attachment) {
  return attachment.soft_part.empty() ? attachment.body : attachment.soft_part;
}

// A muscle of a scene. Its mesh is given by points and triangles, or named by a
// file. If the muscle has no lines, they are made from the meshes when the
// scene is prepared.
struct SceneMuscle {
  std::string name;
  Points points;                       // #V x 3, mm; none: read from mesh_path
  Triangles triangles;                 // #F x 3
  std::vector<ActionLine> lines = {};  // none: to be made from the meshes
  std::vector<Attachment> attachments = {};
  std::string mesh_path = {};
  double mm_per_unit = 1;  // of the points in mesh_path

  // Whether x and y of the points in mesh_path change their signs, because the
  // file states another space than others do (BringIntoOneSpace).
  bool is_turned = false;

  // The muscles on which it ends instead of on bones, such as a tendon with a
  // mesh of its own; none: found on the meshes. Lines that are made go on
  // through them.
  std::optional<std::vector<std::string>> ends_on = {};

  // The bodies on whose bones it ends, that of its origin first; empty: those
  // that are nearest to its mesh.
  std::vector<std::string> end_bodies = {};

  // What the volume of the muscle is compared with, mm^3, where the mesh has
  // less of it already, as that of a label may; 0: the volume of the mesh.
  double delivered_volume = 0;
};

// The mesh of a bone, given as that of a muscle, and the body that it moves
// with. Several bones may belong to one body.
struct SceneBone {
  std::string name;
  Points points;          // #V x 3, mm; none: read from mesh_path
  Triangles triangles;    // #F x 3
  std::string body = {};  // it moves with; empty: named as the bone
  std::string mesh_path = {};
  // What puts the points of the file into the scene: scale and place of meshes
  // that a model names, the unit of those of the scene file.
  Eigen::Matrix4d rest_from_file = Eigen::Matrix4d::Identity();

  // True for a mesh that a model shows and no one asked for, such as an arrow
  // or half a skull: it is left out if no closed surface can be made of it.
  bool is_of_model = false;
  bool is_turned = false;  // before that, as the mesh of a muscle
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
  std::string path;  // of the scene file

  // Where +x, +y and +z point (see geometry/view.h), and the side of the body
  // that "lateral" means. Only pictures of the results depend on them.
  std::string axes = "LPS";
  std::string side = "right";
  bool states_axes = false;  // whether `axes` is more than the default

  // How large the body is against a human one, a power of two: 1 for humans of
  // any size (deformer/body_size.h). Where frames are computed, lengths are in
  // units of as many millimetres, so that all lengths of the method, which are
  // those that suit people, have their meaning; all that is said and returned
  // is in mm.
  double body_size = 1;

  std::vector<SceneMuscle> muscles;
  std::vector<SceneBone> bones;
  std::vector<ScenePose> poses;

  // True if the poses follow each other in time, so that each frame starts from
  // the one before. Otherwise each pose is computed on its own.
  bool is_motion = false;

  // The OpenSim model that the poses come from, and the file that its motion
  // is in, which may be the scene file; null and empty if the poses are given.
  std::shared_ptr<const ModelPoses> model;
  std::string motion_path;

  // All files that were read, or will be: the results depend on them.
  std::vector<std::string> files;

  // What was passed over, and what was found, while reading; for the user.
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

// Reads a scene file (docs/scene.md), and the model and motion that it names.
// Paths in it are relative to `data_root`, or to the folder of the scene file
// if that is empty. `sources` adds to what the file says about its model.
//
// Throws InputError that names the file and the field, for a file that is not
// JSON, an unknown or missing key, a value of the wrong type, coordinates
// beyond kLargestCoordinate, a matrix that is not a rigid motion, and for what
// CheckScene, ReadModel, ReadStorageTable, MotionOf, RampedMotion and BindModel
// refuse.
Scene ReadScene(const std::string& path,
                const std::string& data_root,
                const ModelSources& sources = {});

// Returns the pose at a part (0 to 1) of the way from one pose to another. With
// a model its coordinates are interpolated. Without one bodies move along their
// screw motions. A point of a line goes along with the body whose motion it
// shares, as a point beside a joint has half of its turn, or else straight.
ScenePose PoseBetween(const Scene& scene,
                      const ScenePose& from,
                      const ScenePose& to,
                      double part);

// Returns the bodies that bones, lines and attachments name: each once, in the
// order in which they come.
std::vector<std::string> BodiesInUse(const Scene& scene);

// Returns the pose in which the meshes were made.
ScenePose RestPose(const Scene& scene);

}  // namespace musclewarp
