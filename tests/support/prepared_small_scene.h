// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/solver/gauss_newton.h"
#include "support/small_scene.h"

namespace musclewarp {

// The small scene with hulls of few vertices, for quick tests.
inline PreparedScene PreparedSmallScene(Scene scene = SmallScene()) {
  for (SceneBone& bone : scene.bones) bone.body = bone.name;
  PrepareOptions options;
  options.muscle.hull.coarse_vertices = 60;
  return PrepareScene(scene, options);
}

// The reference solver, each muscle on its own.
inline MuscleSolvers ReferenceSolvers() {
  MuscleSolvers solvers;
  solvers.single = [](const MuscleModel& model,
                      const MuscleTarget& target,
                      Points* coarse,
                      SolverSummary* summary) {
    SolveGaussNewton(model, target, {}, coarse, summary);
  };
  return solvers;
}

}  // namespace musclewarp
