// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/skeleton/polyline.h"
#include "musclewarp/solver/embedded_lines.h"
#include "musclewarp/solver/gauss_newton.h"
#include "musclewarp/solver/muscle_target.h"
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

// Returns the length of the first line of a muscle as its mesh carries it in a
// pose, solved for without contact.
inline double CarriedLength(const PreparedMuscle& muscle,
                            const ScenePose& pose) {
  Points coarse = muscle.model.coarse_rest;
  SolverSummary summary;
  ReferenceSolvers().single(
      muscle.model, TargetOf(muscle.model, pose, {}), &coarse, &summary);
  return PolylineLength(LinesAt(muscle.lines, coarse)[0]);
}

}  // namespace musclewarp
