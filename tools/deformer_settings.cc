// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/deformer_settings.h"

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "tools/flag_values.h"
#include "tools/option_flags.h"

namespace musclewarp {
namespace {

void ChoosePreparation(const DeformerSettings& choices,
                       PrepareOptions* options) {
  options->muscle.hull.coarse_vertices = choices.coarse_vertices;
  options->muscle.laplacian.weights = ParseLaplacian(choices.laplacian);
  if (choices.laplacian_length > 0 &&
      options->muscle.laplacian.weights == LaplacianWeights::kPaper) {
    throw InputError("--laplacian_length",
                     "is for --laplacian=area, and the rows are the paper's",
                     "add --laplacian=area, or leave --laplacian_length out");
  }
  options->muscle.laplacian.length_scale = choices.laplacian_length;
  options->muscle.line_rule = ParseLines(choices.lines);
  options->muscle.sample_spacing = choices.sample_spacing;
  options->muscle.skeleton_weight = choices.skeleton_weight;
  options->muscle.attachment_weight = choices.attachment_weight;
  options->muscle.bending_weight = choices.bending_weight;
  options->attachments = ParseAttachments(choices.attachments);
  options->repair.holes.max_perimeter = choices.max_hole;
  options->auto_lines = choices.auto_lines;
  options->fibres.fibres = choices.fibres;
}

void ChooseCertifiedContact(const DeformerSettings& choices,
                            CertifiedContactOptions* options) {
  SetGap(choices.gap, options);
  if (!(choices.max_step_turn > 0)) {
    throw InputError("--max_step_turn",
                     "is " + std::to_string(choices.max_step_turn),
                     "allowed: above 0");
  }
  options->frame_timeout_s = choices.frame_timeout_s;
  options->step.max_rounds = choices.max_rounds;
  options->limits.max_turn = RadiansOf(choices.max_step_turn);
  options->limits.max_move = choices.max_step_move;
}

}  // namespace

DeformerOptions OptionsOf(const DeformerSettings& choices) {
  DeformerOptions options;
  ChoosePreparation(choices, &options.prepare);
  options.frames.contact = ParseContact(choices.contact);
  options.frames.pre_rotation.use_body_twist = choices.body_twist;
  options.frames.paper.group.level = ParseContactLevel(choices.contact_level);
  options.frames.paper.group.paper.seed = choices.seed;
  options.frames.paper.bone_hull.coarse_vertices = choices.bone_coarse_vertices;
  ChooseCertifiedContact(choices, &options.frames.certified);
  options.reconstruction.kind = ParseRemake(choices.remake);
  options.frames.requirements.max_volume_loss = choices.max_loss;
  options.frames.requirements.max_lost_area = choices.max_lost_area;
  options.frames.requirements.max_lost_extent = choices.max_lost_extent;
  options.frames.requirements.max_torn_patch = choices.max_torn_patch;
  options.solver = ParseSolver(choices.solver);
  SetIterationLimit(choices.max_iterations, &options.solver);
  options.cache.folder = CacheFolderOf(choices.cache);
  options.lengths_in_mm = choices.lengths_in_mm;
  return options;
}

std::string CacheFolderOf(const std::string& cache) {
  return cache == "none" ? "" : cache;
}

void SetIterationLimit(int max_iterations, SolverConfiguration* configuration) {
  if (max_iterations < 1) {
    throw InputError("--max_iterations",
                     "is " + std::to_string(max_iterations),
                     "allowed: 1 or above");
  }
  configuration->gauss_newton.max_iterations = max_iterations;
  configuration->ceres.iteration.max_iterations = max_iterations;
  configuration->ceres.muscle.hard_constraint.max_rounds = max_iterations;
}

}  // namespace musclewarp
