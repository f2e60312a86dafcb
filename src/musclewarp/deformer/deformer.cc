// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/deformer.h"

#include <glog/logging.h>

#include <optional>
#include <utility>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/scene/scene_checks.h"

namespace musclewarp {
namespace {

// Returns the options, with the repairs that the kind of contact requires.
DeformerOptions Completed(DeformerOptions options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  const bool is_certified = options.frames.contact == ContactKind::kCertified;
  options.prepare.remove_self_crossings |= is_certified;
  options.prepare.remove_slivers |= is_certified;
  return options;
}

Scene Checked(Scene scene) {
  for (SceneBone& bone : scene.bones) {
    if (bone.body.empty()) bone.body = bone.name;
  }
  CheckScene(scene);
  return scene;
}

}  // namespace

RestSeparationOptions RestSeparationOptionsOf(const DeformerOptions& options) {
  RestSeparationOptions separation;
  separation.contact = options.frames.certified;
  separation.pre_rotation = options.frames.pre_rotation;
  separation.requirements = options.frames.requirements;
  separation.prepare = options.prepare;
  separation.reconstruction = options.reconstruction;
  return separation;
}

bool DeformerOptions::IsValid(std::string* error) const {
  return prepare.IsValid(error) && frames.IsValid(error) &&
         reconstruction.IsValid(error) && solver.IsValid(error) &&
         cache.IsValid(error);
}

Deformer::Deformer(Scene scene, DeformerOptions options)
    : options_(Completed(std::move(options))),
      solvers_(SolversOf(options_.solver)) {
  std::optional<StageRecording> recording;
  if (options_.record_stages) recording.emplace();
  Preparation preparation = Prepare(Checked(std::move(scene)));
  scene_ = std::make_unique<PreparedScene>(std::move(preparation.scene));
  frame_solver_ = MakeFrameSolver(*scene_,
                                  options_.frames,
                                  std::make_shared<SceneMeshes>(*scene_),
                                  std::move(preparation.rest));
  if (recording) scene_->stages = recording->times();
  // The first MoveTo() computes the start of the motion: with the paper's
  // contact this takes a solve.
}

Preparation Deformer::PrepareAnew(const Scene& scene) const {
  Preparation preparation;
  preparation.scene =
      PrepareScene(scene, options_.prepare, options_.on_progress);
  if (options_.frames.contact == ContactKind::kCertified) {
    preparation.rest = SeparateRest(RestSeparationOptionsOf(options_),
                                    solvers_.single,
                                    options_.on_progress,
                                    &preparation.scene);
  }
  return preparation;
}

Preparation Deformer::Prepare(const Scene& scene) const {
  if (options_.cache.folder.empty()) return PrepareAnew(scene);
  const PreparationCache cache(options_.cache, scene);
  std::optional<Preparation> cached = cache.Read(scene);
  if (cached) {
    for (const std::string& warning : cached->scene.warnings) {
      LOG(WARNING) << warning;
    }
    return *std::move(cached);
  }
  Preparation preparation = PrepareAnew(scene);
  cache.Write(preparation);
  return preparation;
}

Frame Deformer::MoveTo(const ScenePose& pose) {
  CheckPose(scene_->scene, pose);
  if (state_.IsEmpty()) Reset();
  SolvedFrame solved = Solve(pose, &state_);
  state_ = std::move(solved.state);
  return std::move(solved.frame);
}

Frame Deformer::SolveAlone(const ScenePose& pose) {
  CheckPose(scene_->scene, pose);
  return Solve(pose, nullptr).frame;
}

SolvedFrame Deformer::Solve(const ScenePose& pose, const SceneState* before) {
  std::optional<StageRecording> recording;
  if (options_.record_stages) recording.emplace();
  SolvedFrame solved =
      frame_solver_->Solve(solvers_, pose, before, options_.on_progress);
  if (recording) solved.frame.stages = recording->times();
  return solved;
}

void Deformer::Reset() { state_ = frame_solver_->StartOfMotion(solvers_); }

}  // namespace musclewarp
