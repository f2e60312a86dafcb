// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/frame_solvers/paper_scene.h"

namespace musclewarp {

// With the contact of the paper (section 3). A frame on its own starts from the
// unconstrained shapes, with an initial fix: bones do not pass through their
// rest pose on the way. A frame of a motion follows on the one before, in steps
// in which no bone passes through a muscle.
class PaperFrameSolver : public FrameSolver {
 public:
  PaperFrameSolver(const PreparedScene& scene,
                   const FrameSolverOptions& options,
                   std::shared_ptr<SceneMeshes> meshes);

  SceneState StartOfMotion(const MuscleSolvers& solvers) override;
  int ExpectedSteps(const ScenePose* from,
                    const ScenePose& pose) const override;
  SolvedFrame Solve(const MuscleSolvers& solvers,
                    const ScenePose& pose,
                    const SceneState* before,
                    const ProgressCallback& on_progress) override;

 private:
  SolvedPose SolveGroup(const GroupSolver& solver,
                        const ScenePose& pose,
                        const SceneState* before) const;
  // What the next pose starts from: offsets of fine vertices are part of it
  // where contact acts on them. Else they are a last correction, made anew.
  SceneState StateOf(const ScenePose& pose, const SolvedPose& solved) const;

  PaperScene paper_;
};

}  // namespace musclewarp
