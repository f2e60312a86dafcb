// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// What a model needs to know of a muscle in the rest pose.
struct MuscleAtRest {
  std::vector<ActionLine> lines;  // those of the scene, or else made
  double volume = 0;              // MeshPreparation::delivered_volume, mm^3

  // Along which lines that were made go on to bones without a mesh.
  std::vector<BareTendon> bare_tendons;
};

// Returns the muscles of a scene in its order: repairs its meshes and makes
// lines as PrepareScene does with the same options, and nothing more, so that
// it takes a small part of the time. Throws InputError as PrepareScene does.
// Precondition (CHECKed): the options are valid.
std::vector<MuscleAtRest> MusclesAtRest(const Scene& scene,
                                        PrepareOptions options);

}  // namespace musclewarp
