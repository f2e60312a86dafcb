// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/muscles_at_rest.h"

#include <glog/logging.h>

#include <string>
#include <utility>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/preparation/repaired_meshes.h"
#include "musclewarp/preparation/scene_lines.h"
#include "musclewarp/preparation/surroundings.h"

namespace musclewarp {

std::vector<MuscleAtRest> MusclesAtRest(const Scene& scene,
                                        PrepareOptions options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  options.repair.body_size = scene.body_size;
  std::vector<PreparedBone> bones(scene.bones.size());
  std::vector<PreparedMuscle> prepared(scene.muscles.size());
  std::vector<TriangleSoup> meshes(scene.muscles.size());
  // Bones come first, as their meshes are the largest.
  ParallelFor(bones.size() + meshes.size(), [&](size_t i) {
    if (i < bones.size()) {
      bones[i] = RepairBone(options, scene.bones[i]);
      return;
    }
    const size_t m = i - bones.size();
    meshes[m] = RepairMuscle(options, scene.muscles[m], &prepared[m]);
  });
  Surroundings surroundings;
  for (const PreparedBone& bone : bones) {
    if (!bone.left_out.empty()) continue;
    surroundings.AddBone(bone.mesh.name, bone.body, TreesOf(bone));
  }
  for (const TriangleSoup& mesh : meshes) surroundings.AddMuscle(mesh);
  const std::vector<MadeLines> made = MakeSceneLines(
      surroundings, {options.auto_lines, options.made_lines}, {}, scene);
  std::vector<MuscleAtRest> muscles(scene.muscles.size());
  for (size_t m = 0; m < muscles.size(); ++m) {
    const std::vector<ActionLine>& given = scene.muscles[m].lines;
    muscles[m].lines = given.empty() ? made[m].lines : given;
    if (given.empty()) muscles[m].bare_tendons = made[m].bare_tendons;
    muscles[m].volume = prepared[m].mesh.delivered_volume;
  }
  return muscles;
}

}  // namespace musclewarp
