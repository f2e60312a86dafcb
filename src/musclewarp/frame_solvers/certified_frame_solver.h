// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/motion/certified_motion.h"

namespace musclewarp {

// The frame solver with certified contact: muscles cross neither bones nor each
// other in any frame, and the certificate lists violations as shortcomings of
// the frame. An isolated frame starts from the separated rest pose.
class CertifiedFrameSolver : public FrameSolver {
 public:
  // `meshes`: the meshes of the scene, in the rest pose. `rest`: the separated
  // rest pose of the scene.
  CertifiedFrameSolver(const PreparedScene& scene,
                       const FrameSolverOptions& options,
                       std::shared_ptr<SceneMeshes> meshes,
                       RestResult rest);

  SceneState StartOfMotion(const MuscleSolvers& solvers) override;
  int ExpectedSteps(const ScenePose* from,
                    const ScenePose& pose) const override;
  SolvedFrame Solve(const MuscleSolvers& solvers,
                    const ScenePose& pose,
                    const SceneState* before,
                    const ProgressCallback& on_progress) override;

 private:
  const CertifiedScene certified_;
};

}  // namespace musclewarp
