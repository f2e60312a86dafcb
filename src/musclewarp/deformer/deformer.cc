// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/deformer.h"

#include <glog/logging.h>

#include <optional>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/base/text.h"
#include "musclewarp/deformer/body_size.h"
#include "musclewarp/deformer/length_options.h"
#include "musclewarp/figures/scaled_figures.h"
#include "musclewarp/frames/scaled_frame.h"
#include "musclewarp/preparation/bone_pushes.h"
#include "musclewarp/preparation/scaled_preparation.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/scaled_scene.h"
#include "musclewarp/scene/scene_checks.h"

namespace musclewarp {
namespace {

// Returns the options in units of the body's size, with the repairs that the
// kind of contact requires.
DeformerOptions Completed(DeformerOptions options, double body_size) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  AskInMillimetres(options.lengths_in_mm,
                   body_size,
                   &options.prepare,
                   &options.frames.certified,
                   &options.frames.requirements);
  if (!options.IsValid(&error)) {
    throw InputError(
        "options",
        error + ", in a body of " + BodySizeText(body_size) + " human size",
        "ask for a length that suits it");
  }
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

// Returns the same scene if it is in mm already.
std::shared_ptr<const PreparedScene> SceneInMillimetres(
    const std::shared_ptr<const PreparedScene>& scene) {
  if (scene->scene.body_size == 1) return scene;
  const auto scaled = std::make_shared<PreparedScene>(*scene);
  ScaleLengths(scene->scene.body_size, scaled.get());
  return scaled;
}

ContactReport ContactInMillimetres(ContactReport contact, double body_size) {
  contact.gap *= body_size;
  if (contact.rest) ScaleFigures(body_size, &*contact.rest);
  return contact;
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
         reconstruction.IsValid(error) && bone_push.IsValid(error) &&
         solver.IsValid(error) && cache.IsValid(error);
}

Deformer::Deformer(Scene scene, DeformerOptions options)
    : Deformer(SizedScene{InBodyUnits(Checked(std::move(scene)))},
               std::move(options)) {}

Deformer::Deformer(const SizedScene& sized, DeformerOptions options)
    : body_size_(sized.scene.body_size),
      options_(Completed(std::move(options), body_size_)),
      solvers_(SolversOf(options_.solver)) {
  std::optional<StageRecording> recording;
  if (options_.record_stages) recording.emplace();
  Preparation preparation = Prepare(sized.scene);
  if (options_.frames.contact != ContactKind::kPaper) {
    AddBonePushes(options_.bone_push, &preparation.scene);
  }
  const auto scene =
      std::make_shared<PreparedScene>(std::move(preparation.scene));
  scene_ = scene;
  frame_solver_ = MakeFrameSolver(*scene_,
                                  options_.frames,
                                  std::make_shared<SceneMeshes>(*scene_),
                                  std::move(preparation.rest));
  if (recording) scene->stages = recording->times();
  scene_in_mm_ = SceneInMillimetres(scene_);
  contact_ = ContactInMillimetres(frame_solver_->contact(), body_size_);
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

ScenePose Deformer::Sized(ScenePose pose) const {
  ScaleLengths(1 / body_size_, &pose);
  return pose;
}

Frame Deformer::InMillimetres(Frame frame) const {
  if (body_size_ != 1) ScaleLengths(body_size_, &frame);
  return frame;
}

const Frame& Deformer::RestFrame() {
  if (!rest_frame_) rest_frame_ = InMillimetres(frame_solver_->RestFrame());
  return *rest_frame_;
}

Frame Deformer::MoveTo(const ScenePose& pose) {
  CheckPose(scene_in_mm_->scene, pose);
  if (state_.IsEmpty()) Reset();
  SolvedFrame solved = Solve(Sized(pose), &state_);
  state_ = std::move(solved.state);
  return InMillimetres(std::move(solved.frame));
}

Frame Deformer::SolveAlone(const ScenePose& pose) {
  CheckPose(scene_in_mm_->scene, pose);
  return InMillimetres(Solve(Sized(pose), nullptr).frame);
}

int Deformer::ExpectedSteps(const ScenePose* from,
                            const ScenePose& pose) const {
  if (!from) return frame_solver_->ExpectedSteps(nullptr, Sized(pose));
  const ScenePose sized = Sized(*from);
  return frame_solver_->ExpectedSteps(&sized, Sized(pose));
}

SolvedFrame Deformer::Solve(const ScenePose& pose, const SceneState* before) {
  std::optional<StageRecording> recording;
  if (options_.record_stages) recording.emplace();
  const Stopwatch stopwatch;
  const ScenePose with_lines = WithTautLines(scene_->scene, pose);
  const double lines_ms = stopwatch.Milliseconds();
  SolvedFrame solved =
      frame_solver_->Solve(solvers_, with_lines, before, options_.on_progress);
  solved.frame.wall_ms += lines_ms;
  if (recording) solved.frame.stages = recording->times();
  return solved;
}

void Deformer::Reset() { state_ = frame_solver_->StartOfMotion(solvers_); }

}  // namespace musclewarp
