// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scene_warnings.h"

#include <glog/logging.h>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/preparation/dropped_piece_warnings.h"
#include "musclewarp/preparation/scale_warnings.h"
#include "musclewarp/scene/far_lines.h"
#include "musclewarp/scene/folded_lines.h"

namespace musclewarp {

void AddSceneWarnings(const PrepareOptions& options, PreparedScene* prepared) {
  std::vector<std::string>& warnings = prepared->warnings;
  const double body_size = prepared->scene.body_size;
  const auto add = [&](const std::vector<std::string>& more) {
    warnings.insert(warnings.end(), more.begin(), more.end());
  };
  add(prepared->scene.warnings);
  for (const PreparedBone& bone : prepared->bones) {
    add(bone.mesh.notes);
    add(DroppedPieceWarnings(bone.mesh.name, bone.mesh.repairs, body_size));
  }
  for (size_t m = 0; m < prepared->muscles.size(); ++m) {
    const PreparedMuscle& muscle = prepared->muscles[m];
    add(muscle.mesh.notes);
    add(DroppedPieceWarnings(
        muscle.model.name, muscle.mesh.repairs, body_size));
    add(muscle.attachment_warnings);
    add(FarEndWarnings(muscle.model.name, muscle.line_ends, body_size));
    add(muscle.missed_bones);
    add(BareTendonWarnings(muscle.model.name, muscle.bare_tendons, body_size));
    if (muscle.fibres.num_lines() >= options.fibres.fibres) continue;
    warnings.push_back(muscle.model.name + " has room for " +
                       std::to_string(muscle.fibres.num_lines()) +
                       " fibres of " + std::to_string(options.fibres.fibres));
  }
  std::vector<MeshSize> sizes;
  for (const PreparedBone& bone : prepared->bones) {
    sizes.push_back(
        {bone.mesh.name, body_size * BoundingBoxDiagonal(bone.rest.points)});
  }
  for (size_t i = 0; i < prepared->muscles.size(); ++i) {
    const MuscleModel& model = prepared->muscles[i].model;
    sizes.push_back(
        {model.name, body_size * BoundingBoxDiagonal(model.fine_rest)});
    add(FarLineWarnings(
        prepared->scene.muscles[i], model.fine_rest, body_size));
  }
  add(FoldedLineWarnings(prepared->scene));
  add(ScaleWarnings(sizes, options.scale_warning_ratio));
  for (const std::string& warning : warnings) LOG(WARNING) << warning;
}

}  // namespace musclewarp
