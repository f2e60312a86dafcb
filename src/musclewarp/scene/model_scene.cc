// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/model_scene.h"

#include <Eigen/LU>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/opensim/coordinate_motion.h"
#include "musclewarp/opensim/storage_table.h"

namespace musclewarp {
namespace {

ModelRest ReadModelRest(const JsonField& scene, const Model& model) {
  ModelRest rest;
  if (!scene.Has("model_rest")) return rest;
  const JsonField field = scene.At("model_rest");
  field.CheckKeys({"coordinates", "in_degrees", "frame"});
  if (field.Has("frame")) rest.frame = field.At("frame").AsString();
  const JsonField coordinates = field.At("coordinates");
  coordinates.CheckObject();
  const bool in_degrees = field.At("in_degrees").AsBool();
  rest.coordinates.emplace();
  for (const auto& item : coordinates.value().items()) {
    const int index = model.FindCoordinate(item.key());
    const bool is_angle = index >= 0 && model.coordinates[index].kind ==
                                            CoordinateKind::kRotational;
    (*rest.coordinates)[item.key()] = coordinates.At(item.key()).AsNumber() *
                                      (in_degrees && is_angle ? M_PI / 180 : 1);
  }
  return rest;
}

// The model's file of an attached mesh: beside the model, or in a folder
// "Geometry" there or one above, where OpenSim looks.
std::string FindGeometry(const Model& model, const ModelGeometry& geometry) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(model.path).parent_path();
  for (const char* place : {"", "Geometry", "geometry", "../Geometry"}) {
    const fs::path file = folder / place / geometry.file;
    if (fs::exists(file)) return file.lexically_normal().string();
  }
  throw InputError(
      model.path,
      "names the geometry file \"" + geometry.file + "\", which is not there",
      "put it beside the model or into its folder Geometry, or "
      "give the bone a \"mesh\"");
}

// One bone for each mesh of the model on the body of `bone`.
std::vector<SceneBone> BonesOfModel(const SceneBone& bone,
                                    const ModelPoses& poses,
                                    const std::string& where) {
  const int body = poses.model.FindBody(bone.body);
  const auto& geometry = poses.model.bodies[body].geometry;
  if (geometry.empty()) {
    throw InputError(where + ": bone \"" + bone.name + "\"",
                     "has no mesh, and " + poses.model.path +
                         " attaches none to " + bone.body,
                     "give a \"mesh\"");
  }
  std::vector<SceneBone> bones;
  for (const ModelGeometry& mesh : geometry) {
    SceneBone one = bone;
    if (geometry.size() > 1) {
      one.name += "_" + std::filesystem::path(mesh.file).stem().string();
    }
    one.mesh_path = FindGeometry(poses.model, mesh);
    Eigen::Matrix4d scale = Eigen::Matrix4d::Identity();
    scale.diagonal().head<3>() = kMillimetresPerMetre * mesh.scale;
    one.rest_from_file =
        poses.body_from_rest[body].inverse() * mesh.body_from_mesh * scale;
    bones.push_back(std::move(one));
  }
  return bones;
}

}  // namespace

void AddModelPoses(const JsonField& field,
                   Model model,
                   const std::string& motion_path,
                   Scene* scene) {
  const ModelRest rest = ReadModelRest(field, model);
  const std::vector<std::string> bodies = BodiesInUse(*scene);
  if (bodies.empty()) {
    field.Fail("has a model, but neither bones nor lines on its bodies",
               "add \"bones\"");
  }
  scene->warnings = model.warnings;
  scene->motion_path = motion_path;
  const CoordinateMotion motion =
      MotionOf(model, ReadStorageTable(motion_path), motion_path);
  scene->warnings.insert(
      scene->warnings.end(), motion.warnings.begin(), motion.warnings.end());
  auto poses = std::make_shared<ModelPoses>(
      BindModel(std::move(model), rest, bodies, field.file(), &scene->notes));
  poses->given_coordinates = motion.given;
  poses->moving_coordinates = motion.moving;
  for (SceneMuscle& muscle : scene->muscles) {
    for (ActionLine& line : muscle.lines) {
      if (line.rest.rows() > 0) continue;
      poses->muscles.push_back(poses->model.FindMuscle(line.name));
      line = LineOfMuscle(*poses, poses->muscles.back());
    }
  }
  std::vector<SceneBone> bones;
  for (const SceneBone& bone : scene->bones) {
    if (!bone.mesh_path.empty()) {
      bones.push_back(bone);
      continue;
    }
    const auto found = BonesOfModel(bone, *poses, field.file());
    bones.insert(bones.end(), found.begin(), found.end());
  }
  scene->bones = std::move(bones);
  for (size_t i = 0; i < motion.times.size(); ++i) {
    ScenePose pose = PoseAt(*poses, motion.values[i]);
    pose.time = motion.times[i];
    std::ostringstream name;
    name << std::setprecision(10) << "t=" << pose.time;
    pose.name = name.str();
    scene->poses.push_back(std::move(pose));
  }
  scene->model = std::move(poses);
  scene->is_motion = true;
}

}  // namespace musclewarp
