// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/model_bones.h"

#include <Eigen/LU>
#include <filesystem>
#include <set>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/opensim/geometry_files.h"

namespace musclewarp {
namespace {

// Returns a name that no bone has yet: files in different folders may have the
// same name, and both "tibia" with "r_fibula" and "tibia_r" with "fibula" give
// "tibia_r_fibula".
std::string FreeName(const std::string& name, std::set<std::string>* taken) {
  std::string free = name;
  for (int i = 2; !taken->insert(free).second; ++i) {
    free = name + "_" + std::to_string(i);
  }
  return free;
}

// Returns a bone for each mesh that the model attaches to the body of `bone`.
std::vector<SceneBone> BonesOfBody(const SceneBone& bone,
                                   const ModelPoses& poses,
                                   const std::vector<std::string>& folders,
                                   const std::string& where,
                                   std::set<std::string>* names) {
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
      one.name = FreeName(
          one.name + "_" + std::filesystem::path(mesh.file).stem().string(),
          names);
    }
    one.mesh_path = GeometryFile(poses.model, mesh, folders);
    Eigen::Matrix4d scale = Eigen::Matrix4d::Identity();
    scale.diagonal().head<3>() = kMillimetresPerMetre * mesh.scale;
    one.rest_from_file =
        poses.body_from_rest[body].inverse() * mesh.body_from_mesh * scale;
    bones.push_back(std::move(one));
  }
  return bones;
}

}  // namespace

bool AreBonesOfModel(const JsonField& scene) {
  if (!scene.Has("bones") || !scene.At("bones").IsString()) {
    return false;
  }
  const JsonField field = scene.At("bones");
  if (field.AsString() != "model") {
    field.Fail("is \"" + field.AsString() + "\"",
               "give a list of bones, or \"model\"");
  }
  if (!scene.Has("model")) {
    field.Fail("is \"model\", but there is no \"model\"",
               "add the OpenSim model, or give a list of bones");
  }
  return true;
}

void CheckMusclesTellBodies(const JsonField& field, const Scene& scene) {
  for (const SceneMuscle& muscle : scene.muscles) {
    if (!muscle.lines.empty() || !muscle.attachments.empty()) continue;
    field.Fail("is \"model\", but the muscle \"" + muscle.name +
                   "\" does not tell on which bodies it is",
               "give it \"lines\" or \"attachments\", or list the bones");
  }
}

void AddBonesOfMuscles(const ModelPoses& poses,
                       const std::vector<std::string>& bodies,
                       const JsonField& field,
                       Scene* scene) {
  for (const std::string& name : bodies) {
    const int body = poses.model.FindBody(name);
    if (poses.model.bodies[body].geometry.empty()) continue;
    SceneBone bone;
    bone.name = name;
    bone.body = name;
    bone.is_of_model = true;
    scene->bones.push_back(std::move(bone));
  }
  if (scene->bones.empty()) {
    field.Fail("is \"model\", but " + poses.model.path +
                   " attaches no mesh to a body of a muscle",
               "list the bones with their meshes");
  }
}

void AddMeshesOfModel(const ModelPoses& poses,
                      const std::vector<std::string>& folders,
                      const std::string& where,
                      Scene* scene) {
  std::vector<SceneBone> bones;
  std::set<std::string> names;
  for (const SceneBone& bone : scene->bones) names.insert(bone.name);
  for (const SceneBone& bone : scene->bones) {
    if (!bone.mesh_path.empty()) {
      bones.push_back(bone);
      continue;
    }
    const auto found = BonesOfBody(bone, poses, folders, where, &names);
    bones.insert(bones.end(), found.begin(), found.end());
  }
  scene->bones = std::move(bones);
}

}  // namespace musclewarp
