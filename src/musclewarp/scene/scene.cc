// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/geometry/view.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/scene/attachments_file.h"
#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/model_bones.h"
#include "musclewarp/scene/model_scene.h"
#include "musclewarp/scene/named_lines.h"
#include "musclewarp/scene/pieces_field.h"
#include "musclewarp/scene/poses_file.h"
#include "musclewarp/scene/scene_checks.h"
#include "musclewarp/scene/scene_space.h"

namespace musclewarp {
namespace {

std::string Resolve(const std::string& path, const std::string& root) {
  return (std::filesystem::path(root) / path).string();
}

ActionLine ReadInlineLine(const JsonField& field) {
  field.CheckKeys({"name", "rest", "bodies", "slides"});
  ActionLine line;
  line.name = field.At("name").AsString();
  line.rest = field.At("rest").AsPoints();
  if (field.Has("bodies")) line.bodies = field.At("bodies").AsStrings();
  if (field.Has("slides")) line.slides = field.At("slides").AsBool();
  if (line.slides && line.bodies.empty()) {
    field.At("slides").Fail("needs bodies that guide the line",
                            "add \"bodies\", or leave it out");
  }
  return line;
}

// Returns a line for the path of a muscle of the model. Its rest points are set
// when the meshes are placed on the model.
ActionLine ReadModelLine(const Model& model, int muscle) {
  CheckMuscleIsSupported(model, muscle);
  ActionLine line;
  line.name = model.muscles[muscle].name;
  for (const PathPoint& point : model.muscles[muscle].path) {
    line.bodies.push_back(model.bodies[point.body].name);
  }
  return line;
}

ActionLine ReadLine(const JsonField& field, const NamedLines& named) {
  if (!field.IsString()) return ReadInlineLine(field);
  const std::string name = field.AsString();
  // A muscle of the model follows its path in the model, including conditional
  // points.
  const int muscle = named.model ? named.model->FindMuscle(name) : -1;
  if (muscle >= 0) return ReadModelLine(*named.model, muscle);
  const auto line = named.poses_file.lines.find(name);
  if (line == named.poses_file.lines.end()) {
    field.Fail("names the line \"" + name + "\", which " +
                   (named.model ? named.model->path + " does not have"
                                : "the poses_file does not have"),
               DidYouMean(name, named.Names()) +
                   "check the name, or give the line as an object");
  }
  return line->second;
}

Attachment ReadAttachment(const JsonField& field) {
  field.CheckKeys({"body", "points", "radius", "outline", "may_penetrate"});
  Attachment attachment;
  attachment.body = field.At("body").AsString();
  attachment.points = field.At("points").AsPoints();
  attachment.radius = field.At("radius").AsLength();
  if (attachment.points.rows() == 0) {
    field.At("points").Fail("is empty", "give at least one point");
  }
  attachment.is_outline = field.Has("outline") && field.At("outline").AsBool();
  if (field.Has("may_penetrate")) {
    attachment.may_penetrate = field.At("may_penetrate").AsBool();
  }
  return attachment;
}

SceneMuscle ReadMuscle(const JsonField& field,
                       const NamedLines& named,
                       const std::string& root) {
  field.CheckKeys({"name",
                   "mesh",
                   "pieces",
                   "lines",
                   "attachments",
                   "ends_on",
                   "end_bodies",
                   "delivered_volume_mm3"});
  SceneMuscle muscle;
  muscle.name = field.At("name").AsString();
  muscle.mesh_path = Resolve(field.At("mesh").AsString(), root);
  muscle.mm_per_unit = field.mm_per_unit();
  if (field.Has("pieces")) CheckPieces(field.At("pieces"));
  if (field.Has("lines")) {
    const JsonField lines = field.At("lines");
    for (size_t i = 0; i < lines.ArraySize(); ++i) {
      muscle.lines.push_back(ReadLine(lines.At(i), named));
    }
  }
  if (field.Has("attachments")) {
    const JsonField attachments = field.At("attachments");
    for (size_t i = 0; i < attachments.ArraySize(); ++i) {
      muscle.attachments.push_back(ReadAttachment(attachments.At(i)));
    }
  }
  if (field.Has("ends_on")) muscle.ends_on = field.At("ends_on").AsStrings();
  if (field.Has("end_bodies")) {
    muscle.end_bodies = field.At("end_bodies").AsStrings();
  }
  if (field.Has("delivered_volume_mm3")) {
    const JsonField volume = field.At("delivered_volume_mm3");
    muscle.delivered_volume = volume.AsNumber();
    if (muscle.delivered_volume <= 0) {
      volume.Fail("is " + volume.AsText(), "allowed: above 0");
    }
  }
  return muscle;
}

// Reads a bone. Without a mesh it stands for all meshes that the model attaches
// to its body; they are looked up once the meshes are placed on the model.
SceneBone ReadBone(const JsonField& field,
                   const std::string& root,
                   bool has_model) {
  field.CheckKeys({"name", "mesh", "body"});
  SceneBone bone;
  bone.name = field.At("name").AsString();
  if (field.Has("mesh") || !has_model) {
    bone.mesh_path = Resolve(field.At("mesh").AsString(), root);
    bone.rest_from_file.diagonal().head<3>().setConstant(field.mm_per_unit());
  }
  bone.body = field.At("body").AsString();
  return bone;
}

ScenePose ReadPose(const JsonField& field) {
  field.CheckKeys({"name", "time", "bodies", "lines"});
  ScenePose pose;
  pose.name = field.At("name").AsString();
  if (field.Has("time")) pose.time = field.At("time").AsNumber();
  if (field.Has("bodies")) {
    const JsonField bodies = field.At("bodies");
    bodies.CheckObject();
    for (const std::string& member : bodies.Keys()) {
      pose.bodies[member] = bodies.At(member).AsRigidTransform();
    }
  }
  if (field.Has("lines")) {
    const JsonField lines = field.At("lines");
    lines.CheckObject();
    for (const std::string& member : lines.Keys()) {
      pose.lines[member] = lines.At(member).AsPoints();
    }
  }
  return pose;
}

PosesFile ReadPosesFileOf(const JsonField& scene, const std::string& root) {
  const JsonField field = scene.At("poses_file");
  field.CheckKeys({"path", "bodies"});
  std::map<std::string, std::vector<std::string>> body_keys;
  if (field.Has("bodies")) {
    const JsonField bodies = field.At("bodies");
    bodies.CheckObject();
    for (const std::string& member : bodies.Keys()) {
      const JsonField names = bodies.At(member);
      body_keys[member] = names.IsArray()
                              ? names.AsStrings()
                              : std::vector<std::string>{names.AsString()};
    }
  }
  return ReadPosesFile(Resolve(field.At("path").AsString(), root), body_keys);
}

// Adds the areas of an attachments_file to the muscles that it names.
void AddAttachments(const JsonField& scene_field,
                    const std::string& root,
                    Scene* scene) {
  const JsonField field = scene_field.At("attachments_file");
  field.CheckKeys({"path", "bodies", "radius", "outline", "may_penetrate"});
  const JsonField bodies_field = field.At("bodies");
  bodies_field.CheckObject();
  std::map<std::string, std::string> bodies;
  for (const std::string& member : bodies_field.Keys()) {
    bodies[member] = bodies_field.At(member).AsString();
  }
  const double radius = field.At("radius").AsLength();
  const bool is_outline = field.Has("outline") && field.At("outline").AsBool();
  const bool may_penetrate =
      field.Has("may_penetrate") && field.At("may_penetrate").AsBool();
  const std::string path = Resolve(field.At("path").AsString(), root);
  const auto attachments = ReadAttachmentsFile(path, bodies, radius);
  scene->files.push_back(path);
  for (SceneMuscle& muscle : scene->muscles) {
    const auto found = attachments.find(muscle.name);
    if (found == attachments.end()) continue;
    for (Attachment attachment : found->second) {
      attachment.is_outline = is_outline;
      attachment.may_penetrate = may_penetrate;
      muscle.attachments.push_back(std::move(attachment));
    }
  }
}

// Removes the targets of lines that no muscle of the scene uses.
void KeepTargetsInUse(Scene* scene) {
  std::map<std::string, bool> in_use;
  for (const auto& muscle : scene->muscles) {
    for (const auto& line : muscle.lines) in_use[line.name] = true;
  }
  for (auto& pose : scene->poses) {
    for (auto line = pose.lines.begin(); line != pose.lines.end();) {
      line =
          in_use.count(line->first) ? std::next(line) : pose.lines.erase(line);
    }
  }
}

// Returns true if the times of the poses increase, which makes them a motion.
// Poses without times are not a motion.
bool TimesRise(const std::vector<ScenePose>& poses) {
  for (size_t i = 0; i + 1 < poses.size(); ++i) {
    if (poses[i].time >= poses[i + 1].time) return false;
  }
  return poses.size() > 1;
}

void ReadBodyAxes(const JsonField& field, Scene* scene) {
  if (field.Has("axes")) {
    scene->axes = field.At("axes").AsString();
    scene->states_axes = true;
    if (!AreBodyAxes(scene->axes)) {
      field.At("axes").Fail(
          "is \"" + scene->axes + "\"",
          "give one letter for +x, +y and +z out of L or R, A or P, S or I, "
          "such as \"LPS\"");
    }
  }
  if (field.Has("side")) {
    scene->side = field.At("side").AsString();
    if (scene->side != "right" && scene->side != "left") {
      field.At("side").Fail("is \"" + scene->side + "\"",
                            "allowed: \"right\", \"left\"");
    }
  }
}

// Checks the keys of the scene file, including keys that exclude or require
// each other.
void CheckSceneFile(const JsonField& field, bool has_other_motion) {
  field.CheckKeys({"name",
                   "units",
                   "axes",
                   "side",
                   "muscles",
                   "bones",
                   "poses",
                   "poses_file",
                   "attachments_file",
                   "model",
                   "model_rest",
                   "geometry",
                   "motion",
                   "motion_in_degrees"});
  const bool has_model = field.Has("model");
  if (has_model && field.Has("poses")) {
    field.Fail("has both \"poses\" and a \"model\"", "leave one of them out");
  }
  if (has_model) return;
  for (const char* key :
       {"motion", "model_rest", "geometry", "motion_in_degrees"}) {
    if (!field.Has(key)) continue;
    field.Fail("has \"" + std::string(key) + "\" but no \"model\"",
               "add the OpenSim model");
  }
  if (has_other_motion) {
    field.Fail("has no \"model\" for a motion", "add the OpenSim model");
  }
}

JsonField ReadSceneFile(const std::string& path, bool has_other_motion) {
  const JsonField field = JsonField::ParseFile(path);
  CheckSceneFile(field, has_other_motion);
  return field.InItsUnits();
}

// Reads the poses of the scene file, then those of its poses_file. With a
// model, only the lines of that file are used.
void ReadPoses(const JsonField& field,
               const std::string& root,
               NamedLines* named,
               Scene* scene) {
  if (field.Has("poses")) {
    const JsonField poses = field.At("poses");
    for (size_t i = 0; i < poses.ArraySize(); ++i) {
      scene->poses.push_back(ReadPose(poses.At(i)));
    }
  }
  if (!field.Has("poses_file")) return;
  named->poses_file = ReadPosesFileOf(field, root);
  if (named->model != nullptr) return;
  const auto& poses = named->poses_file.poses;
  scene->poses.insert(scene->poses.end(), poses.begin(), poses.end());
}

void ReadMeshes(const JsonField& field,
                const std::string& root,
                const NamedLines& named,
                Scene* scene) {
  const JsonField muscles = field.At("muscles");
  for (size_t i = 0; i < muscles.ArraySize(); ++i) {
    scene->muscles.push_back(ReadMuscle(muscles.At(i), named, root));
  }
  if (field.Has("bones") && !AreBonesOfModel(field)) {
    const JsonField bones = field.At("bones");
    for (size_t i = 0; i < bones.ArraySize(); ++i) {
      scene->bones.push_back(
          ReadBone(bones.At(i), root, named.model != nullptr));
    }
  }
  if (scene->muscles.empty()) muscles.Fail("is empty", "add a muscle");
}

// Adds the files on which the results depend, unless they are listed already.
void AddFiles(const JsonField& field, const std::string& root, Scene* scene) {
  scene->files.push_back(scene->path);
  for (const char* key : {"poses_file", "model"}) {
    if (!field.Has(key)) continue;
    const JsonField file = field.At(key);
    scene->files.push_back(
        Resolve((file.Has("path") ? file.At("path") : file).AsString(), root));
  }
  // A motion may be in the scene file itself.
  if (scene->model && scene->motion_path != scene->path) {
    scene->files.push_back(scene->motion_path);
  }
  for (const auto& muscle : scene->muscles) {
    scene->files.push_back(MeshFileOf(muscle.mesh_path));
  }
  for (const auto& bone : scene->bones) {
    scene->files.push_back(MeshFileOf(bone.mesh_path));
  }
}

}  // namespace

Scene ReadScene(const std::string& path,
                const std::string& data_root,
                const ModelSources& sources) {
  const JsonField field = ReadSceneFile(path, !sources.motion.empty());
  const std::string root =
      data_root.empty() ? std::filesystem::path(path).parent_path().string()
                        : data_root;
  Scene scene;
  scene.name = field.At("name").AsString();
  scene.path = path;
  ReadBodyAxes(field, &scene);
  NamedLines named;
  std::optional<Model> model;
  if (field.Has("model")) {
    model = ReadModel(Resolve(field.At("model").AsString(), root));
    named.model = &*model;
  }
  ReadPoses(field, root, &named, &scene);
  ReadMeshes(field, root, named, &scene);
  if (field.Has("attachments_file")) AddAttachments(field, root, &scene);
  if (model) {
    AddModelPoses(field, root, sources, std::move(*model), &scene);
  } else {
    scene.is_motion = TimesRise(scene.poses);
  }
  if (scene.poses.empty()) {
    field.Fail("has no pose",
               "add \"poses\", a \"poses_file\", or \"model\" and "
               "\"motion\"");
  }
  if (field.Has("poses_file")) KeepTargetsInUse(&scene);
  CheckScene(scene);
  BringIntoOneSpace(&scene);
  AddFiles(field, root, &scene);
  return scene;
}

}  // namespace musclewarp
