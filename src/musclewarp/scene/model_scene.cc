// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/model_scene.h"

#include <filesystem>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/opensim/coordinate_motion.h"
#include "musclewarp/opensim/storage_table.h"
#include "musclewarp/scene/designed_postures.h"
#include "musclewarp/scene/model_bones.h"
#include "musclewarp/scene/ramped_motion.h"
#include "musclewarp/scene/scene.h"

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
  for (const std::string& member : coordinates.Keys()) {
    const int index = model.FindCoordinate(member);
    const bool is_angle = index >= 0 && model.coordinates[index].kind ==
                                            CoordinateKind::kRotational;
    (*rest.coordinates)[member] =
        coordinates.At(member).AsNumber() *
        (in_degrees && is_angle ? kRadiansPerDegree : 1);
  }
  return rest;
}

std::string PathIn(const std::string& root, const std::string& path) {
  return (std::filesystem::path(root) / path).string();
}

// Returns the mesh folders given for the run, then those of the scene.
std::vector<std::string> MeshFolders(const JsonField& scene,
                                     const std::string& root,
                                     const ModelSources& sources) {
  std::vector<std::string> folders = sources.geometry;
  if (!scene.Has("geometry")) return folders;
  const JsonField field = scene.At("geometry");
  const auto names = field.IsArray()
                         ? field.AsStrings()
                         : std::vector<std::string>{field.AsString()};
  for (const std::string& name : names) {
    folders.push_back(PathIn(root, name));
    if (!std::filesystem::is_directory(folders.back())) {
      field.Fail(
          "names \"" + name + "\", and there is no folder " + folders.back(),
          "give a folder with meshes of the model");
    }
  }
  return folders;
}

// Reads the motion given for the run or, without one, the motion or the design
// of postures of the scene: a file, or an object in the scene file. Sets
// Scene::motion_path and Scene::design.
CoordinateMotion ReadMotion(const JsonField& field,
                            const std::string& root,
                            const ModelSources& sources,
                            const Model& model,
                            const std::vector<std::string>& bodies,
                            Scene* scene) {
  std::optional<bool> in_degrees = sources.motion_in_degrees;
  if (!in_degrees && field.Has("motion_in_degrees")) {
    in_degrees = field.At("motion_in_degrees").AsBool();
  }
  const auto read_file = [&](const std::string& file) {
    const std::string path = PathIn(root, file);
    scene->motion_path = path;
    return MotionOf(model, ReadStorageTable(path), path, in_degrees);
  };
  if (!sources.motion.empty()) return read_file(sources.motion);
  const JsonField motion = field.At("motion");
  if (motion.IsString()) return read_file(motion.AsString());
  if (!motion.IsObject()) {
    motion.Fail("is " + motion.AsText(),
                "give the path of a motion in quotes, or an object with "
                "\"frames\" and \"coordinates\", or with \"design\" and "
                "\"postures\"");
  }
  if (in_degrees && !*in_degrees) {
    motion.Fail("has its angles in degrees, and motion_in_degrees says no",
                "leave motion_in_degrees out: it is for motion files");
  }
  scene->motion_path = field.file();
  if (!IsDesign(motion)) return RampedMotion(motion, model);
  DesignedPostures postures = ReadDesignedPostures(motion, model, bodies);
  scene->design = postures.design;
  scene->notes.push_back(postures.note);
  return std::move(postures.motion);
}

// Throws InputError if a column of the motion has a name that several joints
// share and one of these joints moves a body of the scene.
void CheckMotionIsKnown(const CoordinateMotion& motion,
                        const Model& model,
                        const std::vector<std::string>& bodies,
                        const std::string& path) {
  for (const int coordinate : motion.ambiguous) {
    for (const std::string& name : bodies) {
      const int body = model.FindBody(name);
      if (body < 0 || !MovesBody(model, coordinate, body)) continue;
      const std::string& known_as = model.coordinates[coordinate].name;
      throw InputError(
          path,
          "has a column \"" + known_as.substr(known_as.find('/') + 1) +
              "\", which may mean " + known_as + ", and this moves " + name,
          "name the column by the path of its coordinate: "
          "/jointset/" +
              known_as + "/value");
    }
  }
}

// Returns a unique name for the pose at a time: the time with ten digits, or as
// many digits as distinguish it from other times.
std::string PoseName(double time, std::set<std::string>* taken) {
  constexpr int kExact = std::numeric_limits<double>::max_digits10;
  std::string name;
  for (int digits = 10; digits <= kExact; ++digits) {
    name = "t=" + NumberText(time, digits);
    if (taken->insert(name).second) return name;
  }
  // Another pose has the same time.
  name += "_" + std::to_string(taken->size());
  taken->insert(name);
  return name;
}

void AddPoses(const CoordinateMotion& motion,
              const ModelPoses& poses,
              Scene* scene) {
  std::set<std::string> names;
  for (size_t i = 0; i < motion.times.size(); ++i) {
    ScenePose pose = PoseAt(poses, motion.values[i]);
    pose.time = motion.times[i];
    pose.name = scene->design.empty() ? PoseName(pose.time, &names)
                                      : "posture_" + std::to_string(i);
    scene->poses.push_back(std::move(pose));
  }
}

}  // namespace

void AddModelPoses(const JsonField& field,
                   const std::string& root,
                   const ModelSources& sources,
                   Model model,
                   Scene* scene) {
  const ModelRest rest = ReadModelRest(field, model);
  if (AreBonesOfModel(field)) {
    CheckMusclesTellBodies(field.At("bones"), *scene);
  }
  const std::vector<std::string> bodies = BodiesInUse(*scene);
  if (bodies.empty()) {
    field.Fail("has a model, but neither bones nor lines on its bodies",
               "add \"bones\"");
  }
  scene->warnings = model.warnings;
  CoordinateMotion motion =
      ReadMotion(field, root, sources, model, bodies, scene);
  scene->warnings.insert(
      scene->warnings.end(), motion.warnings.begin(), motion.warnings.end());
  CheckMotionIsKnown(motion, model, bodies, scene->motion_path);
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
  if (AreBonesOfModel(field)) {
    AddBonesOfMuscles(*poses, bodies, field.At("bones"), scene);
  }
  AddMeshesOfModel(
      *poses, MeshFolders(field, root, sources), field.file(), scene);
  scene->is_motion = scene->design.empty();
  if (!scene->is_motion) {
    scene->reached_from = VisitAsTree(poses->model, poses->rest, &motion);
  }
  AddPoses(motion, *poses, scene);
  scene->model = std::move(poses);
}

}  // namespace musclewarp
