// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/frame_solvers/paper_scene.h"

namespace musclewarp {

// The frame solver with the contact of the paper (section 3). An isolated frame
// starts from the unconstrained shapes in its pose, with an initial fix,
// instead of a motion from the rest pose. A frame of a motion starts from the
// one before, in steps so small that no bone passes through a muscle.
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
  // Returns the start of the next pose. With contact at the fine level it
  // includes the offsets of fine vertices; at the coarse level these are a
  // final correction, recomputed for every pose.
  SceneState StateOf(const ScenePose& pose, const SolvedPose& solved) const;

  PaperScene paper_;
};

}  // namespace musclewarp
