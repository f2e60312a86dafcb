// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene_space.h"

#include <algorithm>

#include "musclewarp/mesh_files/stated_space.h"

namespace musclewarp {
namespace {

// Returns true if the file has the frame of the scene, up to a uniform scale.
bool IsOnlyScaled(const Eigen::Matrix4d& rest_from_file) {
  const Eigen::Vector4d scale = rest_from_file.diagonal();
  return rest_from_file.isDiagonal(0) && scale[3] == 1 &&
         scale[1] == scale[0] && scale[2] == scale[0];
}

}  // namespace

void BringIntoOneSpace(Scene* scene) {
  std::vector<StatedFile> files;
  std::vector<bool*> marks;
  const auto add = [&](const std::string& path, bool* is_turned) {
    if (path.empty()) return;
    files.push_back({path, StatedSpace(path)});
    marks.push_back(is_turned);
  };
  for (SceneMuscle& muscle : scene->muscles) {
    add(muscle.mesh_path, &muscle.is_turned);
  }
  for (SceneBone& bone : scene->bones) {
    if (IsOnlyScaled(bone.rest_from_file)) add(bone.mesh_path, &bone.is_turned);
  }
  const CommonSpace common =
      FindCommonSpace(files,
                      scene->states_axes ? scene->axes : "",
                      scene->path.empty() ? "axes" : scene->path + ": axes");
  for (size_t i = 0; i < files.size(); ++i) *marks[i] = common.is_turned[i];
  if (!scene->states_axes && !common.space.empty() &&
      common.space != scene->axes) {
    scene->axes = common.space;
    scene->notes.push_back("axes: " + common.space + ", as the meshes state");
  }
  std::vector<std::string>& warnings = scene->warnings;
  for (const std::string& warning : common.warnings) {
    if (std::count(warnings.begin(), warnings.end(), warning) > 0) continue;
    warnings.push_back(warning);
  }
}

}  // namespace musclewarp
