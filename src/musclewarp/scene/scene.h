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

// An area where a muscle is attached to a body: the part of the muscle's
// surface within `radius` (mm) of any of `points` (#P x 3, mm, rest pose).
struct Attachment {
  std::string body;

  // The muscle to which it is attached, instead of a body; empty for a body.
  // Such attachments are detected; scene files cannot name them.
  std::string soft_part;

  Points points;
  double radius = 0;

  // If true, the points are the boundary of the area, in order, and vertices
  // inside it belong to the area if they lie within `radius` of the body's
  // bones.
  bool is_outline = false;

  // If true, triangles of the area may cross bones of the body. These crossings
  // are counted separately.
  bool may_penetrate = false;
};

// Returns the name of the body or soft part that carries an attachment.
inline const std::string& NameOfCarrier(const Attachment& attachment) {
  return attachment.soft_part.empty() ? attachment.body : attachment.soft_part;
}

// A muscle of a scene. Its mesh is given by points and triangles, or by the
// path of a file. If the muscle has no lines, they are made from the meshes
// when the scene is prepared.
struct SceneMuscle {
  std::string name;
  Points points;                       // #V x 3, mm; none: read from mesh_path
  Triangles triangles;                 // #F x 3
  std::vector<ActionLine> lines = {};  // none: to be made from the meshes
  std::vector<Attachment> attachments = {};
  std::string mesh_path = {};
  double mm_per_unit = 1;  // of the points in mesh_path

  // If true, x and y of the points in mesh_path change sign, because the file
  // states another coordinate system than the scene (BringIntoOneSpace).
  bool is_turned = false;

  // The muscles on which it ends instead of on bones, such as a tendon with its
  // own mesh; none: they are detected on the meshes. Lines that are made for
  // the muscle continue through them.
  std::optional<std::vector<std::string>> ends_on = {};

  // The bodies of its origin and its insertion, in this order; empty: the
  // bodies nearest to its mesh.
  std::vector<std::string> end_bodies = {};

  // The volume with which the volume of the muscle is compared, mm^3, if the
  // mesh has already lost a part of it, as the mesh of a label may have; 0: the
  // volume of the mesh.
  double delivered_volume = 0;
};

// A bone of a scene: its mesh, given like that of a muscle, and the body that
// it moves with. A body may have several bones.
struct SceneBone {
  std::string name;
  Points points;          // #V x 3, mm; none: read from mesh_path
  Triangles triangles;    // #F x 3
  std::string body = {};  // that it moves with; empty: named like the bone
  std::string mesh_path = {};
  // The transform from the points of the file to the scene (mm): the scale and
  // placement of a mesh that a model names, or the unit of a mesh that the
  // scene file names.
  Eigen::Matrix4d rest_from_file = Eigen::Matrix4d::Identity();

  // True for a mesh that the model displays but the scene does not list, such
  // as an arrow or half a skull: it is left out if it cannot be repaired to a
  // closed surface.
  bool is_of_model = false;
  bool is_turned = false;  // as in SceneMuscle; applied before rest_from_file
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

  // The anatomical directions of +x, +y and +z (see geometry/view.h), and the
  // side of the body to which "lateral" refers. Only pictures of the results
  // depend on them.
  std::string axes = "LPS";
  std::string side = "right";
  bool states_axes = false;  // true if `axes` is not merely the default

  // The size of the body relative to a human one, a power of two: 1 for humans
  // of any size (deformer/body_size.h). While frames are computed, lengths are
  // in units of `body_size` mm, so that the length parameters of the method,
  // which are chosen for humans, suit the body. All messages and results are in
  // mm.
  double body_size = 1;

  std::vector<SceneMuscle> muscles;
  std::vector<SceneBone> bones;
  std::vector<ScenePose> poses;

  // True if the poses are a sequence in time, so that each frame starts from
  // the previous one. Otherwise each pose is computed independently.
  bool is_motion = false;

  // The design of postures of which the poses are, "latin_hypercube" or "grid",
  // or empty for other poses; and for each of its poses the number of the pose
  // from which it is reached, which comes before it, or -1 for the rest pose
  // (scene/designed_postures.h).
  std::string design;
  std::vector<int> reached_from;

  // The OpenSim model that provides the poses, and the file that contains its
  // motion, which may be the scene file; null and empty if the scene gives its
  // poses itself.
  std::shared_ptr<const ModelPoses> model;
  std::string motion_path;

  // All files that have been or will be read: the results depend on them.
  std::vector<std::string> files;

  // Sentences for the user about ignored input and about findings while
  // reading.
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

// Reads a scene file (docs/scene.md), and the model and motion that it names.
// Paths in it are relative to `data_root` or, if that is empty, to the folder
// of the scene file. `sources` overrides or extends what the file states about
// its model.
//
// Throws InputError that names the file and the field, for a file that is not
// JSON, an unknown or missing key, a value of the wrong type, coordinates
// beyond kLargestCoordinate, a matrix that is not a rigid motion, and as
// CheckScene, ReadModel, ReadStorageTable, MotionOf, RampedMotion and BindModel
// do.
Scene ReadScene(const std::string& path,
                const std::string& data_root,
                const ModelSources& sources = {});

// Returns the pose at the fraction `part` (0 to 1) of the way between two
// poses. With a model, its coordinates are interpolated. Without one, bodies
// move along their screw motions. A point of a line follows the screw motion of
// a body if a share of that motion takes the point from one pose to the other,
// as half of a joint's rotation does next to the joint; otherwise it moves
// straight.
ScenePose PoseBetween(const Scene& scene,
                      const ScenePose& from,
                      const ScenePose& to,
                      double part);

// Returns the number of the pose from which a pose is reached: the one before
// in a motion, the one that the tree of a design has; -1 for the rest pose.
int PoseBefore(const Scene& scene, int pose);

// Returns the bodies that bones, lines and attachments name, without
// duplicates, in order of first occurrence.
std::vector<std::string> BodiesInUse(const Scene& scene);

// Returns the pose in which the meshes were made.
ScenePose RestPose(const Scene& scene);

}  // namespace musclewarp
