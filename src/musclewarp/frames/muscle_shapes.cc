// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/muscle_shapes.h"

namespace musclewarp {

MuscleShapes ShapesOf(const PreparedScene& scene,
                      const std::vector<MuscleState>& states) {
  MuscleShapes shapes;
  shapes.coarse.resize(states.size());
  shapes.fine.resize(states.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < states.size(); ++i) {
    shapes.coarse[i] = states[i].coarse;
    shapes.fine[i] = FinePoints(scene.muscles[i].model, states[i]);
  }
  return shapes;
}

std::vector<Points> FinePointsOf(const PreparedScene& scene,
                                 const SceneState* state) {
  if (!state) return {};
  return ShapesOf(scene, state->muscles).fine;
}

}  // namespace musclewarp
