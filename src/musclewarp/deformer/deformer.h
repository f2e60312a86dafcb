// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "musclewarp/base/progress.h"
#include "musclewarp/deformer/preparation_cache.h"
#include "musclewarp/deformer/solver_configuration.h"
#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/frame_solvers/rest_separation.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

struct DeformerOptions {
  // How meshes are repaired, wrapped and analysed. Slivers are removed from
  // muscles for certified contact, whatever these options say.
  PrepareOptions prepare;

  // The kind of contact, and how poses are reached.
  FrameSolverOptions frames;

  // What happens to meshes that cannot be separated in the rest pose.
  ReconstructionOptions reconstruction;

  SolverConfiguration solver;

  // Where preparations are kept from run to run; by default nowhere.
  PreparationCacheOptions cache;

  // Measure how long the stages of each frame take (Frame::stages), and those
  // of the preparation (PreparedScene::stages).
  bool record_stages = false;

  // Called while the scene is prepared and moved. It may throw to stop.
  ProgressCallback on_progress;

  // Also checks the options within.
  bool IsValid(std::string* error) const;
};

// Deforms the muscles of a scene: the whole of musclewarp behind one class.
//
//   Scene scene = ReadScene("hip.json", data_root);
//   Deformer deformer(scene, DeformerOptions());
//   for (const ScenePose& pose : scene.poses) {
//     const Frame frame = deformer.MoveTo(pose);
//     if (!frame.IsUsable()) LOG(WARNING) << frame.FullReport();
//     Show(frame.muscles[0].points);
//   }
//
// The constructor repairs the meshes, wraps them in coarse hulls, factors the
// constant matrices and, with certified contact, separates meshes that overlap
// as they are delivered. That takes seconds; a frame takes a fraction of one.
class Deformer {
 public:
  // Throws InputError if the scene contradicts itself, a mesh cannot be read or
  // repaired, the rest pose cannot be made free of crossings, or the folder of
  // the cache cannot be made. Precondition (CHECKed): the options are valid.
  explicit Deformer(Scene scene, DeformerOptions options = {});

  // Moves the muscles from where they are to a pose. Frames of a motion follow
  // each other like this, in small steps and without jumps. Throws InputError
  // for a pose that contradicts the scene (CheckPose), as SolveAlone() does.
  Frame MoveTo(const ScenePose& pose);

  // Returns the frame of a pose that is on its own: it does not depend on where
  // the muscles are now, and they stay there.
  Frame SolveAlone(const ScenePose& pose);

  // Moves the muscles back to where a motion starts.
  void Reset();

  // Returns the scene as it was delivered and repaired, before any contact.
  const Frame& RestFrame() { return frame_solver_->RestFrame(); }

  // Returns the meshes after repair, the hulls, and everything else that does
  // not change with the pose.
  const PreparedScene& scene() const { return *scene_; }

  // Returns a description of the contact as it was prepared.
  const ContactReport& contact() const { return frame_solver_->contact(); }

  // Returns in how many steps a pose can be reached from the pose `from` or, if
  // that is null, by SolveAlone(), if they are short. Fewer may do, but the
  // time of a frame can be foretold by their number.
  int ExpectedSteps(const ScenePose* from, const ScenePose& pose) const {
    return frame_solver_->ExpectedSteps(from, pose);
  }

  // Where the muscles are, to be put back later. A state that was put in must
  // be one of the same scene and options.
  const SceneState& state() const { return state_; }
  void set_state(SceneState state) { state_ = std::move(state); }

 private:
  // Returns the scene prepared and separated, from the cache if it is there.
  Preparation Prepare(const Scene& scene) const;
  Preparation PrepareAnew(const Scene& scene) const;

  SolvedFrame Solve(const ScenePose& pose, const SceneState* before);

  const DeformerOptions options_;
  const MuscleSolvers solvers_;
  std::unique_ptr<PreparedScene> scene_;
  std::unique_ptr<FrameSolver> frame_solver_;
  SceneState state_;
};

}  // namespace musclewarp
