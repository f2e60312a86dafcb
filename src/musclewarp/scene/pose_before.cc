// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene.h"

namespace musclewarp {

int PoseBefore(const Scene& scene, int pose) {
  if (!scene.reached_from.empty()) return scene.reached_from[pose];
  return scene.is_motion ? pose - 1 : -1;
}

}  // namespace musclewarp
