// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/subject/subject.h"

namespace musclewarp {

Scene SceneOfSubject(const Subject& subject, double mm_per_unit) {
  Scene scene;
  scene.name = "the files";
  scene.warnings = subject.warnings;
  for (const SubjectMesh& mesh : subject.bones) {
    SceneBone bone;
    bone.name = bone.body = mesh.name;
    bone.mesh_path = mesh.file;
    bone.is_turned = mesh.is_turned;
    if (mesh.file.empty()) {
      bone.points = mesh.mesh.points;
      bone.triangles = mesh.mesh.triangles;
    } else {
      bone.rest_from_file.diagonal().head<3>().setConstant(mm_per_unit);
    }
    scene.bones.push_back(std::move(bone));
  }
  for (const SubjectMesh& mesh : subject.muscles) {
    SceneMuscle muscle;
    muscle.name = mesh.name;
    muscle.mesh_path = mesh.file;
    muscle.is_turned = mesh.is_turned;
    muscle.delivered_volume = mesh.delivered_volume;
    if (mesh.file.empty()) {
      muscle.points = mesh.mesh.points;
      muscle.triangles = mesh.mesh.triangles;
    } else {
      muscle.mm_per_unit = mm_per_unit;
    }
    scene.muscles.push_back(std::move(muscle));
  }
  return scene;
}

std::vector<Bone> BonesOf(const Subject& subject) {
  std::vector<Bone> bones;
  for (const SubjectMesh& mesh : subject.bones) {
    bones.push_back(
        {mesh.name, mesh.bone.kind, mesh.bone.side, mesh.body, mesh.mesh});
  }
  return bones;
}

}  // namespace musclewarp
