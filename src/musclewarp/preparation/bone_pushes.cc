// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bone_pushes.h"

#include <memory>
#include <vector>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/solver/bone_push.h"

namespace musclewarp {
namespace {

std::vector<BoneField> FieldsOf(const BonePushOptions& options,
                                const std::vector<PreparedBone>& bones) {
  // Three of them are given up at the border of the field.
  constexpr double kSpacingsReached = 5;
  const double spacing = options.field_spacing;
  std::vector<BoneField> fields;
  for (const PreparedBone& bone : bones) {
    if (bone.rest.triangles.rows() == 0) continue;
    fields.push_back({bone.body,
                      std::make_shared<const DistanceField>(
                          bone.rest, spacing, kSpacingsReached * spacing)});
  }
  return fields;
}

}  // namespace

void AddBonePushes(const BonePushOptions& options, PreparedScene* scene) {
  if (!options.enabled) return;
  const ScopedStage stage("push of bones");
  const Stopwatch watch;
  const std::vector<BoneField> fields = FieldsOf(options, scene->bones);
  ParallelFor(scene->muscles.size(), [&](size_t i) {
    MuscleModel& model = scene->muscles[i].model;
    model.bone_push = PrepareBonePush(options, fields, model);
  });
  scene->wall_ms += watch.Milliseconds();
}

}  // namespace musclewarp
