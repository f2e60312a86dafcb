// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/deformer_settings.h"

#include "musclewarp/base/memory.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

// Of the memory that is left: the rest is for files and other programs.
constexpr double kShareOfMemory = 0.8;

void SetMuscleOptions(const DeformerSettings& settings,
                      MuscleModelOptions* muscle) {
  muscle->hull.coarse_vertices = settings.coarse_vertices;
  muscle->laplacian.weights = Named(
      settings.laplacian, {LaplacianWeights::kArea, LaplacianWeights::kPaper});
  muscle->laplacian.length_scale = settings.laplacian_length;
  muscle->line_rule = Named(
      settings.lines, {LineRule::kTendon, LineRule::kSlide, LineRule::kFixed});
  muscle->sample_spacing = settings.sample_spacing;
  muscle->skeleton_weight = settings.skeleton_weight;
  muscle->attachment_weight = settings.attachment_weight;
  muscle->bending_weight = settings.bending_weight;
}

void SetFrameOptions(const DeformerSettings& settings,
                     FrameSolverOptions* frames) {
  frames->contact =
      Named(settings.contact,
            {ContactKind::kCertified, ContactKind::kPaper, ContactKind::kNone});
  frames->pre_rotation.use_body_twist = settings.body_twist;
  frames->paper.group.level = Named(
      settings.contact_level, {ContactLevel::kCoarse, ContactLevel::kFine});
  frames->paper.group.paper.seed = settings.seed;
  frames->paper.bone_hull.coarse_vertices = settings.bone_coarse_vertices;
  CertifiedContactOptions& certified = frames->certified;
  certified.frame_timeout_s = settings.frame_timeout_s;
  certified.step.max_rounds = settings.max_rounds;
  certified.limits.max_turn = RadiansOf(settings.max_step_turn);
  certified.limits.max_move = settings.max_step_move;
  frames->requirements.max_torn_patch = settings.max_torn_patch;
}

}  // namespace

DeformerOptions OptionsOf(const DeformerSettings& settings) {
  CheckSettings(settings);
  if (settings.laplacian_length > 0 && settings.laplacian == "paper") {
    throw InputError("{laplacian_length}",
                     "is for {laplacian}=area, and the rows are the paper's",
                     "add {laplacian}=area, or leave {laplacian_length} out");
  }
  DeformerOptions options;
  options.bone_push.enabled = settings.bone_push;
  SetOptions(settings,
             &options.prepare,
             &options.frames.certified,
             &options.frames.requirements,
             &options.reconstruction);
  SetMuscleOptions(settings, &options.prepare.muscle);
  options.prepare.attachments =
      settings.attachments == "auto"    ? AttachmentKind::kAuto
      : settings.attachments == "scene" ? AttachmentKind::kScene
                                        : AttachmentKind::kNone;
  options.prepare.auto_lines = settings.auto_lines;
  options.prepare.made_lines =
      Named(settings.made_lines, {LineCourse::kTaut, LineCourse::kGuided});
  options.prepare.fibres.fibres = settings.fibres;
  SetFrameOptions(settings, &options.frames);
  options.solver = SolverConfigurationNamed(settings.solver);
  SetIterationLimit(settings.max_iterations, &options.solver);
  options.prepare.max_memory = settings.max_memory_gib > 0
                                   ? settings.max_memory_gib * kBytesPerGib
                                   : kShareOfMemory * AvailableMemory();
  if (settings.cache != "none") options.cache.folder = settings.cache;
  options.cache.options_key = KeyOf(settings);
  options.lengths_in_mm = LengthsInMillimetres(settings);
  return options;
}

void SetIterationLimit(int max_iterations, SolverConfiguration* configuration) {
  configuration->gauss_newton.max_iterations = max_iterations;
  configuration->ceres.iteration.max_iterations = max_iterations;
  configuration->ceres.muscle.hard_constraint.max_rounds = max_iterations;
}

}  // namespace musclewarp
