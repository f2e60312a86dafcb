// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/scene_state.h"

namespace musclewarp {

SceneState RestState(const PreparedScene& scene) {
  SceneState state;
  state.pose = RestPose(scene.scene);
  for (const PreparedMuscle& muscle : scene.muscles) {
    state.muscles.push_back({muscle.model.coarse_rest, {}});
  }
  return state;
}

}  // namespace musclewarp
