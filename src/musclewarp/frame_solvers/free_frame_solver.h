// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/frame_solvers/frame_solver.h"

namespace musclewarp {

// The frame solver without contact: every muscle deforms on its own, in one
// step, whatever the motion.
class FreeFrameSolver : public FrameSolver {
 public:
  FreeFrameSolver(const PreparedScene& scene,
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
  std::vector<std::string> ShortcomingsOf(const Frame& frame) const;
};

}  // namespace musclewarp
