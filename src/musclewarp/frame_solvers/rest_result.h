// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/certified_contact/contact_state.h"

namespace musclewarp {

// The rest pose of a scene once SeparateRest() has separated it: what takes
// long to find, and all that certified contact needs to start. Muscles are
// numbered as in the scene.
struct RestResult {
  ContactState state;

  // What is left in it, by the exact tests of the certificate.
  SceneIntersections intersections;

  // The muscles that contact has moved farther than the requirements on frames
  // allow, most likely because a bone or another muscle cuts off a part of
  // them.
  std::vector<int> displaced;

  // The muscles whose meshes were made anew. MeshPreparation::reconstruction
  // says why and where.
  std::vector<int> reconstructed;

  double wall_ms = 0;
};

}  // namespace musclewarp
