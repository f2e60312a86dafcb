// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene_checks.h"

#include <map>
#include <set>
#include <string>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

std::string Quoted(const std::string& name) { return "\"" + name + "\""; }

// Meshes of a frame are written as <name>.<ext>: names are file names.
void CheckMeshName(const Scene& scene,
                   const std::string& name,
                   std::set<std::string>* seen) {
  if (name.find('/') != std::string::npos || name == "." || name == "..") {
    throw InputError(scene.path,
                     "the name " + Quoted(name) + " cannot be a file name",
                     "choose a name without \"/\"");
  }
  if (!seen->insert(name).second) {
    throw InputError(scene.path,
                     "the name " + Quoted(name) + " is given twice",
                     "muscles and bones need names of their own");
  }
}

void CheckBody(const Scene& scene,
               const std::string& body,
               const std::set<std::string>& bodies,
               const std::string& used_by) {
  if (bodies.count(body)) return;
  std::string known;
  for (const auto& name : bodies) known += (known.empty() ? "" : ", ") + name;
  throw InputError(
      scene.path,
      used_by + " names the body " + Quoted(body) + ", which no bone has",
      known.empty() ? "add a bone with that body"
                    : "bodies of the bones: " + known);
}

void CheckLine(const Scene& scene,
               const SceneMuscle& muscle,
               const ActionLine& line,
               const std::set<std::string>& bodies) {
  const std::string where =
      scene.path + ": line " + Quoted(line.name) + " of muscle " + muscle.name;
  if (line.rest.rows() < 2) {
    throw InputError(
        where,
        "has " + std::to_string(line.rest.rows()) + " points in \"rest\"",
        "give at least 2");
  }
  for (Eigen::Index i = 0; i + 1 < line.rest.rows(); ++i) {
    if (line.rest.row(i) == line.rest.row(i + 1)) {
      throw InputError(where,
                       "repeats point " + std::to_string(i) + " as point " +
                           std::to_string(i + 1),
                       "remove one of them");
    }
  }
  if (!line.bodies.empty() &&
      static_cast<Eigen::Index>(line.bodies.size()) != line.rest.rows()) {
    throw InputError(where,
                     "has " + std::to_string(line.bodies.size()) +
                         " bodies for " + std::to_string(line.rest.rows()) +
                         " points",
                     "give one body a point, or none");
  }
  for (const auto& body : line.bodies) CheckBody(scene, body, bodies, where);
}

void CheckTargets(const Scene& scene,
                  const ScenePose& pose,
                  const std::map<std::string, const ActionLine*>& lines) {
  for (const auto& [name, target] : pose.lines) {
    const std::string where = scene.path + ": target of line " + Quoted(name) +
                              " in pose " + Quoted(pose.name);
    const auto line = lines.find(name);
    if (line == lines.end()) {
      throw InputError(where, "no muscle has such a line", "check the name");
    }
    if (target.rows() != line->second->rest.rows()) {
      throw InputError(where,
                       "has " + std::to_string(target.rows()) +
                           " points, the rest line has " +
                           std::to_string(line->second->rest.rows()),
                       "give the same number of points");
    }
  }
}

}  // namespace

void CheckScene(const Scene& scene) {
  std::set<std::string> mesh_names;
  std::set<std::string> bodies;
  for (const auto& bone : scene.bones) {
    CheckMeshName(scene, bone.name, &mesh_names);
    bodies.insert(bone.body);
  }
  if (scene.model) {
    for (const int body : scene.model->bodies) {
      bodies.insert(scene.model->model.bodies[body].name);
    }
  }
  std::map<std::string, const ActionLine*> lines;
  for (const auto& muscle : scene.muscles) {
    CheckMeshName(scene, muscle.name, &mesh_names);
    for (const auto& line : muscle.lines) {
      CheckLine(scene, muscle, line, bodies);
      if (!lines.emplace(line.name, &line).second) {
        throw InputError(scene.path,
                         "the line " + Quoted(line.name) + " is given twice",
                         "lines need names of their own");
      }
    }
    for (const auto& attachment : muscle.attachments) {
      CheckBody(scene,
                attachment.body,
                bodies,
                "an attachment of muscle " + muscle.name);
    }
  }
  std::set<std::string> pose_names;
  for (const auto& pose : scene.poses) {
    if (!pose_names.insert(pose.name).second) {
      throw InputError(scene.path,
                       "the pose " + Quoted(pose.name) + " is given twice",
                       "poses need names of their own");
    }
    for (const auto& body : pose.bodies) {
      CheckBody(scene, body.first, bodies, "pose " + Quoted(pose.name));
    }
    CheckTargets(scene, pose, lines);
  }
}

}  // namespace musclewarp
