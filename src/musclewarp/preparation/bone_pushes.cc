// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bone_pushes.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/solver/bone_push.h"

namespace musclewarp {
namespace {

std::vector<BodyField> FieldsOf(const std::vector<PreparedBone>& bones) {
  std::map<std::string, std::vector<TriangleSoup>> surfaces;
  for (const PreparedBone& bone : bones) {
    surfaces[bone.body].push_back(bone.rest);
  }
  std::vector<BodyField> fields;
  for (const auto& [body, of_body] : surfaces) {
    fields.push_back({body,
                      std::make_shared<const DistanceField>(
                          of_body, kPushFieldSpacing, kPushFieldReach)});
  }
  return fields;
}

}  // namespace

void AddBonePushes(PreparedScene* scene) {
  const ScopedStage stage("push of bones");
  const Stopwatch watch;
  const std::vector<BodyField> fields = FieldsOf(scene->bones);
  ParallelFor(scene->muscles.size(), [&](size_t i) {
    MuscleModel& model = scene->muscles[i].model;
    model.bone_push = PrepareBonePush(fields, model);
  });
  scene->wall_ms += watch.Milliseconds();
}

}  // namespace musclewarp
