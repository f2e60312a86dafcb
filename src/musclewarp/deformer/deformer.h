// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <set>
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
#include "musclewarp/solver/bone_push_options.h"

namespace musclewarp {

// All options of a Deformer: preparation, contact, solver and cache.
struct DeformerOptions {
  // Repair, hulls and analysis of the meshes. Certified contact always removes
  // self-crossings, and slivers of muscles, whatever these options say.
  PrepareOptions prepare;

  // The kind of contact, and the steps to a pose.
  FrameSolverOptions frames;

  // Reconstruction of meshes that cannot be separated in the rest pose.
  ReconstructionOptions reconstruction;

  // How bones push the shapes that muscles have without contact aside, so that
  // contact has less to do. With the contact of the paper they never do.
  BonePushOptions bone_push;

  SolverConfiguration solver;

  // Lengths among these options are those that suit people; in bodies of other
  // size they are larger or smaller accordingly (body_size.h). Those that are
  // named here are in mm whatever the size (length_options.h).
  std::set<std::string> lengths_in_mm;

  // The cache of preparations on disk; disabled by default.
  PreparationCacheOptions cache;

  // If true, measures the times of the stages of each frame (Frame::stages) and
  // of the preparation (PreparedScene::stages).
  bool record_stages = false;

  // Called during preparation and motion. May be empty, and may throw to abort.
  ProgressCallback on_progress;

  // Also checks the nested options.
  bool IsValid(std::string* error) const;
};

// Returns the options of the separation of the rest pose among them.
RestSeparationOptions RestSeparationOptionsOf(const DeformerOptions& options);

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
// as delivered. Construction takes seconds, a frame a fraction of a second.
class Deformer {
 public:
  // Throws InputError if the scene contradicts itself, a mesh cannot be read or
  // repaired, the rest pose cannot be made intersection-free, the folder of the
  // cache cannot be created, or a length that was asked for in mm does not suit
  // the size of the body. Precondition (CHECKed): the options are valid.
  explicit Deformer(Scene scene, DeformerOptions options = {});

  // Moves the muscles from their current state to a pose. Consecutive calls
  // compute a motion, in small steps and without jumps. Throws InputError for a
  // pose that contradicts the scene (CheckPose), as SolveAlone() does.
  Frame MoveTo(const ScenePose& pose);

  // Returns the frame of an isolated pose: it is independent of the current
  // state, which does not change.
  Frame SolveAlone(const ScenePose& pose);

  // Moves the muscles back to the start of a motion.
  void Reset();

  // Returns the frame of the scene as delivered and repaired, before any
  // contact.
  const Frame& RestFrame();

  // Returns the repaired meshes, the hulls and all other data that is
  // independent of the pose, in mm.
  const PreparedScene& scene() const { return *scene_in_mm_; }

  // Returns a description of the prepared contact.
  const ContactReport& contact() const { return contact_; }

  // Returns the number of short steps to a pose from the pose `from` or, if
  // that is null, of SolveAlone(). The actual number may be smaller; the
  // estimate serves to predict the time of a frame.
  int ExpectedSteps(const ScenePose* from, const ScenePose& pose) const;

  // The current state of the muscles, to be restored later. set_state()
  // requires a state of the same scene and options.
  const SceneState& state() const { return state_; }
  void set_state(SceneState state) { state_ = std::move(state); }

 private:
  // `scene`: in units of its body's size.
  struct SizedScene {
    Scene scene;
  };
  Deformer(const SizedScene& sized, DeformerOptions options);

  // Returns the prepared and separated scene, from the cache if available.
  Preparation Prepare(const Scene& scene) const;
  Preparation PrepareAnew(const Scene& scene) const;

  // Return a pose in units of the body's size, and a frame in mm.
  ScenePose Sized(ScenePose pose) const;
  Frame InMillimetres(Frame frame) const;

  SolvedFrame Solve(const ScenePose& pose, const SceneState* before);

  // All in units of the body's size (Scene::body_size), as is the state.
  const double body_size_;
  const DeformerOptions options_;
  const MuscleSolvers solvers_;
  std::shared_ptr<const PreparedScene> scene_;
  std::unique_ptr<FrameSolver> frame_solver_;
  SceneState state_;

  // The same for users, in mm.
  std::shared_ptr<const PreparedScene> scene_in_mm_;
  ContactReport contact_;
  std::optional<Frame> rest_frame_;
};

}  // namespace musclewarp
