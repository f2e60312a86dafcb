// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/poses_file.h"

#include <sstream>

#include "musclewarp/scene/json_fields.h"

namespace musclewarp {
namespace {

ActionLine ReadLineOfFile(const std::string& name, const JsonField& field) {
  ActionLine line;
  line.name = name;
  line.rest = field.At("rest").AsPoints();
  if (field.Has("bodies")) line.bodies = field.At("bodies").AsStrings();
  return line;
}

using BodyKeys = std::map<std::string, std::vector<std::string>>;

ScenePose ReadPoseOfFile(const JsonField& field, const BodyKeys& body_keys) {
  field.CheckObject();
  ScenePose pose;
  std::ostringstream coordinates_text;
  for (const auto& item : field.value().items()) {
    if (!item.value().is_number() || item.key() == "time") continue;
    pose.coordinates[item.key()] = field.At(item.key()).AsNumber();
    coordinates_text << (pose.coordinates.size() > 1 ? "_" : "") << item.key()
                     << "_" << pose.coordinates[item.key()];
  }
  pose.name =
      field.Has("name") ? field.At("name").AsString() : coordinates_text.str();
  if (pose.name.empty()) {
    field.Fail("has neither a name nor a coordinate", "add a \"name\"");
  }
  if (field.Has("time")) pose.time = field.At("time").AsNumber();
  for (const auto& [key, bodies] : body_keys) {
    const Eigen::Matrix4d transform = field.At(key).AsRigidTransform();
    for (const std::string& body : bodies) pose.bodies[body] = transform;
  }
  const JsonField targets = field.At("target");
  targets.CheckObject();
  for (const auto& item : targets.value().items()) {
    pose.lines[item.key()] = targets.At(item.key()).AsPoints();
  }
  return pose;
}

}  // namespace

PosesFile ReadPosesFile(const std::string& path, const BodyKeys& body_keys) {
  const JsonField root = JsonField::ParseFile(path).InItsUnits();
  PosesFile file;
  const JsonField lines = root.At("lines");
  lines.CheckObject();
  for (const auto& item : lines.value().items()) {
    file.lines[item.key()] = ReadLineOfFile(item.key(), lines.At(item.key()));
  }
  const JsonField poses = root.At("poses");
  for (size_t i = 0; i < poses.ArraySize(); ++i) {
    file.poses.push_back(ReadPoseOfFile(poses.At(i), body_keys));
  }
  return file;
}

}  // namespace musclewarp
