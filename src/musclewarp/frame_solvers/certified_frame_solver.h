// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/motion/certified_motion.h"

namespace musclewarp {

// With certified contact: muscles cross neither bones nor each other in any
// frame, and what a frame does not hold of that is among its shortcomings. A
// frame on its own starts from the separated rest pose.
class CertifiedFrameSolver : public FrameSolver {
 public:
  CertifiedFrameSolver(const PreparedScene& scene,
                       const FrameSolverOptions& options,
                       const MuscleSolvers& solvers,
                       std::shared_ptr<SceneMeshes> meshes,
                       const ProgressCallback& on_progress,
                       std::optional<SeparatedRest> rest);

  std::optional<SeparatedRest> separated_rest() const override;
  SceneState StartOfMotion(const MuscleSolvers& solvers) override;
  int ExpectedSteps(const ScenePose* from,
                    const ScenePose& pose) const override;
  SolvedFrame Solve(const MuscleSolvers& solvers,
                    const ScenePose& pose,
                    const SceneState* before,
                    const ProgressCallback& on_progress) override;

 private:
  // The pairs of muscles that lie on each other in a frame.
  std::vector<std::pair<int, int>> TouchingMuscles(const Frame& frame) const;

  // Returns the fine meshes of a state as they would be without contact, in the
  // order of the scene: each free shape, with its attachments in place.
  std::vector<Points> MeshesWithoutContact(const ContactState& state) const;

  // Measures how far attachments have left their bodies.
  void MeasureDrift(const ContactState& state, Frame* frame) const;

  // Measures what contact has done to the muscles of a frame, against their
  // shapes without contact.
  void MeasureContact(const ContactState& state, Frame* frame);

  // Returns the muscles that contact has moved too far in the rest pose.
  std::vector<int> DisplacedAtRest();

  // Returns what the certificate judges of a muscle.
  MuscleMeasures MeasuresOf(const MuscleFrame& muscle, size_t number) const;

  // Lists what the frame does not hold of the requirements.
  void Judge(Frame* frame);

  // Looks for bones that lie in each other where the frame falls short: they
  // may be why. Precondition: the meshes of the bones are at the frame.
  void AddBoneOverlaps(Frame* frame) const;

  CertifiedScene certified_;
};

}  // namespace musclewarp
