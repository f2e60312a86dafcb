// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/certified_contact/contact_state.h"

namespace musclewarp {

// The separated rest pose of a scene, the result of SeparateRest() and the
// start of certified contact. Worth caching, as it takes long to compute.
// Muscles are numbered as in the scene.
struct RestResult {
  ContactState state;

  // The remaining intersections, by the exact tests of the certificate.
  SceneIntersections intersections;

  // The muscles whose displacement by contact exceeds the requirements on
  // frames, most likely because a bone or another muscle cuts off a part of
  // them.
  std::vector<int> displaced;

  // The muscles with reconstructed meshes. MeshPreparation::reconstruction has
  // the reason and the place.
  std::vector<int> reconstructed;

  double wall_ms = 0;
};

}  // namespace musclewarp
