// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Serialization of a Scene by cereal, and of what reports say of its contact. A
// scene brings the text of its OpenSim model along, but not the files of its
// meshes, which are read when it is prepared.

#include <string>

#include "musclewarp/deformer/preparation_archive.h"
#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

template <class Archive>
void save(Archive& archive, const Model& model) {
  archive(model.path, model.text);
}

template <class Archive>
void load(Archive& archive, Model& model) {
  std::string path, text;
  archive(path, text);
  model = ModelFromText(text, path);
}

MUSCLEWARP_ARCHIVE(ModelPoses,
                   model,
                   rest,
                   scene_from_ground,
                   body_from_rest,
                   bodies,
                   muscles,
                   given_coordinates,
                   moving_coordinates,
                   body_size)
MUSCLEWARP_ARCHIVE(Scene,
                   name,
                   path,
                   axes,
                   side,
                   states_axes,
                   body_size,
                   muscles,
                   bones,
                   poses,
                   is_motion,
                   design,
                   reached_from,
                   model,
                   motion_path,
                   files,
                   warnings,
                   notes)
MUSCLEWARP_ARCHIVE(ContactReport,
                   kind,
                   name,
                   is_solved_together,
                   gap,
                   level,
                   seed,
                   warnings,
                   prepare_ms,
                   rest,
                   displaced_at_rest)

}  // namespace musclewarp
