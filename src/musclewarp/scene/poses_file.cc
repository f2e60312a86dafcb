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
  for (const std::string& member : field.Keys()) {
    if (!field.At(member).IsNumber() || member == "time") continue;
    pose.coordinates[member] = field.At(member).AsNumber();
    coordinates_text << (pose.coordinates.size() > 1 ? "_" : "") << member
                     << "_" << pose.coordinates[member];
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
  for (const std::string& member : targets.Keys()) {
    pose.lines[member] = targets.At(member).AsPoints();
  }
  return pose;
}

}  // namespace

PosesFile ReadPosesFile(const std::string& path, const BodyKeys& body_keys) {
  const JsonField root = JsonField::ParseFile(path).InItsUnits();
  PosesFile file;
  const JsonField lines = root.At("lines");
  lines.CheckObject();
  for (const std::string& member : lines.Keys()) {
    file.lines[member] = ReadLineOfFile(member, lines.At(member));
  }
  const JsonField poses = root.At("poses");
  for (size_t i = 0; i < poses.ArraySize(); ++i) {
    file.poses.push_back(ReadPoseOfFile(poses.At(i), body_keys));
  }
  return file;
}

}  // namespace musclewarp
