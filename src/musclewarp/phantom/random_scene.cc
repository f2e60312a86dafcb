// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/random_scene.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/random_draws.h"
#include "musclewarp/phantom/random_bones.h"
#include "musclewarp/phantom/random_muscles.h"
#include "musclewarp/phantom/random_poses.h"
#include "musclewarp/phantom/scene_parts.h"

namespace musclewarp {
namespace {

using phantom::RandomBone;
using phantom::RandomMuscle;

std::string NumberedName(int number) {
  return std::string("muscle_") + (number < 10 ? "0" : "") +
         std::to_string(number);
}

// Draws muscles until there are `count`; fewer if there is no room. The largest
// size falls with the attempts, so that the last ones find a place.
std::vector<RandomMuscle> DrawMuscles(const std::vector<RandomBone>& bones,
                                      int count,
                                      RandomDraws* draws) {
  constexpr int kAttempts = 150;  // for each muscle
  std::vector<RandomMuscle> muscles;
  while (static_cast<int>(muscles.size()) < count) {
    const std::string name = NumberedName(static_cast<int>(muscles.size()) + 1);
    std::optional<RandomMuscle> muscle;
    for (int i = 0; i < kAttempts && !muscle; ++i) {
      const double size = 1 - i / static_cast<double>(kAttempts);
      muscle = DrawMuscle(name, bones, muscles, size, draws);
    }
    if (!muscle) return muscles;
    muscles.push_back(std::move(*muscle));
  }
  return muscles;
}

PhantomScene Assemble(std::vector<RandomBone> bones,
                      std::vector<RandomMuscle> muscles,
                      std::vector<ScenePose> poses) {
  PhantomScene made;
  made.scene.name = "random";
  made.scene.axes = "RAS";
  made.scene.poses = std::move(poses);
  for (RandomMuscle& muscle : muscles) {
    SceneMuscle entry = phantom::MuscleOf(muscle.mesh, muscle.lines);
    entry.attachments = phantom::AttachmentsAtEnds(muscle.mesh, muscle.lines);
    made.scene.muscles.push_back(std::move(entry));
    made.meshes.push_back(std::move(muscle.mesh));
  }
  for (RandomBone& bone : bones) {
    made.scene.bones.push_back(
        {bone.name, {}, {}, bone.name, bone.name + ".ply"});
    made.meshes.push_back(std::move(bone.mesh));
  }
  return made;
}

}  // namespace

PhantomScene MakeRandomScene(uint32_t seed, int num_muscles, int num_poses) {
  constexpr int kAttempts = 100;
  RandomDraws draws(seed);
  const int drawn = draws.Integer(2, 20);
  const int count = num_muscles == 0 ? drawn : num_muscles;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<RandomBone> bones = phantom::DrawBones(&draws);
    std::vector<RandomMuscle> muscles = DrawMuscles(bones, count, &draws);
    if (static_cast<int>(muscles.size()) < count) continue;
    std::vector<ScenePose> poses =
        phantom::DrawPoses(bones, muscles, &draws, num_poses);
    if (poses.empty()) continue;
    return Assemble(std::move(bones), std::move(muscles), std::move(poses));
  }
  LOG(FATAL) << "no scene found for seed " << seed;
  return {};
}

}  // namespace musclewarp
