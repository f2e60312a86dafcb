// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene.h"

#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/poses_file.h"
#include "musclewarp/scene/scene_checks.h"

namespace musclewarp {
namespace {

std::string Resolve(const std::string& path, const std::string& root) {
  return (std::filesystem::path(root) / path).string();
}

ActionLine ReadInlineLine(const JsonField& field) {
  field.CheckKeys({"name", "rest", "bodies"});
  ActionLine line;
  line.name = field.At("name").AsString();
  line.rest = field.At("rest").AsPoints();
  if (field.Has("bodies")) line.bodies = field.At("bodies").AsStrings();
  return line;
}

ActionLine ReadLine(const JsonField& field, const PosesFile& poses_file) {
  if (!field.value().is_string()) return ReadInlineLine(field);
  const auto line = poses_file.lines.find(field.AsString());
  if (line == poses_file.lines.end()) {
    field.Fail("names the line \"" + field.AsString() +
                   "\", which the poses_file does not have",
               "check the name, or give the line as an object");
  }
  return line->second;
}

Attachment ReadAttachment(const JsonField& field) {
  field.CheckKeys({"body", "points", "radius"});
  Attachment attachment;
  attachment.body = field.At("body").AsString();
  attachment.points = field.At("points").AsPoints();
  attachment.radius = field.At("radius").AsNumber();
  if (attachment.points.rows() == 0) {
    field.At("points").Fail("is empty", "give at least one point");
  }
  if (attachment.radius <= 0) {
    field.At("radius").Fail("is not above 0", "give the radius in mm");
  }
  return attachment;
}

SceneMuscle ReadMuscle(const JsonField& field,
                       const PosesFile& poses_file,
                       const std::string& root) {
  field.CheckKeys({"name", "mesh", "lines", "attachments"});
  SceneMuscle muscle;
  muscle.name = field.At("name").AsString();
  muscle.mesh_path = Resolve(field.At("mesh").AsString(), root);
  const JsonField lines = field.At("lines");
  for (size_t i = 0; i < lines.ArraySize(); ++i) {
    muscle.lines.push_back(ReadLine(lines.At(i), poses_file));
  }
  if (muscle.lines.empty()) {
    lines.Fail("is empty", "a muscle follows at least one line");
  }
  if (field.Has("attachments")) {
    const JsonField attachments = field.At("attachments");
    for (size_t i = 0; i < attachments.ArraySize(); ++i) {
      muscle.attachments.push_back(ReadAttachment(attachments.At(i)));
    }
  }
  return muscle;
}

SceneBone ReadBone(const JsonField& field, const std::string& root) {
  field.CheckKeys({"name", "mesh", "body"});
  return {field.At("name").AsString(),
          Resolve(field.At("mesh").AsString(), root),
          field.At("body").AsString()};
}

ScenePose ReadPose(const JsonField& field) {
  field.CheckKeys({"name", "time", "bodies", "lines"});
  ScenePose pose;
  pose.name = field.At("name").AsString();
  if (field.Has("time")) pose.time = field.At("time").AsNumber();
  if (field.Has("bodies")) {
    const JsonField bodies = field.At("bodies");
    bodies.CheckObject();
    for (const auto& item : bodies.value().items()) {
      pose.bodies[item.key()] = bodies.At(item.key()).AsRigidTransform();
    }
  }
  if (field.Has("lines")) {
    const JsonField lines = field.At("lines");
    lines.CheckObject();
    for (const auto& item : lines.value().items()) {
      pose.lines[item.key()] = lines.At(item.key()).AsPoints();
    }
  }
  return pose;
}

PosesFile ReadPosesFileOf(const JsonField& scene, const std::string& root) {
  const JsonField field = scene.At("poses_file");
  field.CheckKeys({"path", "bodies"});
  std::map<std::string, std::string> body_keys;
  if (field.Has("bodies")) {
    const JsonField bodies = field.At("bodies");
    bodies.CheckObject();
    for (const auto& item : bodies.value().items()) {
      body_keys[item.key()] = bodies.At(item.key()).AsString();
    }
  }
  return ReadPosesFile(Resolve(field.At("path").AsString(), root), body_keys);
}

// Targets of lines that no muscle of the scene uses do not concern it.
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

}  // namespace

Scene ReadScene(const std::string& path, const std::string& data_root) {
  const JsonField field = JsonField::ParseFile(path);
  field.CheckKeys({"name",
                   "units",
                   "muscles",
                   "bones",
                   "poses",
                   "poses_file",
                   "model",
                   "motion"});
  if (field.Has("model") || field.Has("motion")) {
    field.Fail(
        "names an OpenSim model or motion, which this version does not "
        "read",
        "give \"poses\" or a \"poses_file\"");
  }
  if (field.At("units").AsString() != "mm") {
    field.At("units").Fail("is \"" + field.At("units").AsString() + "\"",
                           "allowed: \"mm\"; scale the meshes");
  }
  const std::string root =
      data_root.empty() ? std::filesystem::path(path).parent_path().string()
                        : data_root;

  Scene scene;
  scene.name = field.At("name").AsString();
  scene.path = path;
  if (field.Has("poses")) {
    const JsonField poses = field.At("poses");
    for (size_t i = 0; i < poses.ArraySize(); ++i) {
      scene.poses.push_back(ReadPose(poses.At(i)));
    }
  }
  PosesFile poses_file;
  if (field.Has("poses_file")) {
    poses_file = ReadPosesFileOf(field, root);
    scene.poses.insert(
        scene.poses.end(), poses_file.poses.begin(), poses_file.poses.end());
  }
  const JsonField muscles = field.At("muscles");
  for (size_t i = 0; i < muscles.ArraySize(); ++i) {
    scene.muscles.push_back(ReadMuscle(muscles.At(i), poses_file, root));
  }
  if (field.Has("bones")) {
    const JsonField bones = field.At("bones");
    for (size_t i = 0; i < bones.ArraySize(); ++i) {
      scene.bones.push_back(ReadBone(bones.At(i), root));
    }
  }
  if (scene.muscles.empty()) muscles.Fail("is empty", "add a muscle");
  if (scene.poses.empty()) {
    field.Fail("has no pose", "add \"poses\" or a \"poses_file\"");
  }
  if (field.Has("poses_file")) KeepTargetsInUse(&scene);
  CheckScene(scene);
  return scene;
}

}  // namespace musclewarp
