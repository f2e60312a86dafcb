// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/option_flags.h"

#include "musclewarp/deformer/length_options.h"

namespace musclewarp {
namespace {

const FlagsOfFields& FlagsOfPreparation() {
  static const FlagsOfFields kFlags = {
      {"CotangentLaplacianOptions::length_scale", "laplacian_length"},
      {"FibreOptions::fibres", "fibres"},
      {"HoleLimits::max_perimeter", "max_hole"},
      {"MuscleModelOptions::attachment_weight", "attachment_weight"},
      {"MuscleModelOptions::bending_weight", "bending_weight"},
      {"MuscleModelOptions::sample_spacing", "sample_spacing"},
      {"MuscleModelOptions::skeleton_weight", "skeleton_weight"},
      {"OuterHullOptions::coarse_vertices", "coarse_vertices"},
      {"PrepareOptions::auto_lines", "auto_lines"}};
  return kFlags;
}

// Bones have hulls, too: the same field under another flag.
const FlagsOfFields& FlagsOfContact() {
  static const FlagsOfFields kFlags = {
      {"OuterHullOptions::coarse_vertices", "bone_coarse_vertices"},
      {"FrameRequirements::max_torn_patch", "max_torn_patch"},
      {"FrameRequirements::max_volume_loss", "max_loss"},
      {"FrameRequirements::max_lost_area", "max_lost_area"},
      {"FrameRequirements::max_lost_extent", "max_lost_extent"},
      {"FrameRequirements::displacement_allowance", "max_move"},
      {"StepOptions::gap", "gap"},
      {"StepOptions::max_rounds", "max_rounds"},
      {"StepLimits::max_move", "max_step_move"},
      {"CertifiedContactOptions::frame_timeout_s", "frame_timeout_s"}};
  return kFlags;
}

// One flag limits the iterations of every solver.
const FlagsOfFields& FlagsOfSolver() {
  static const FlagsOfFields kFlags = {
      {"GaussNewtonOptions::max_iterations", "max_iterations"},
      {"GroupIterationOptions::max_iterations", "max_iterations"},
      {"HardConstraintOptions::max_rounds", "max_iterations"}};
  return kFlags;
}

template <typename Options>
void ThrowIfInvalid(const Options& options, const FlagsOfFields& flags) {
  std::string message;
  if (!options.IsValid(&message)) throw FlagError(message, flags);
}

}  // namespace

InputError FlagError(const std::string& message, const FlagsOfFields& flags) {
  const std::string separator = ", allowed: ";
  for (const auto& [field, flag] : flags) {
    if (message.compare(0, field.size() + 1, field + " ") != 0) continue;
    const size_t end = message.find(separator);
    if (end == std::string::npos) break;
    const size_t begin = field.size() + 1;
    return InputError("--" + flag,
                      message.substr(begin, end - begin),
                      message.substr(end + 2));
  }
  return InputError("options", message, "see --help");
}

void CheckValid(const DeformOptions& options) {
  ThrowIfInvalid(options.deformer.prepare, FlagsOfPreparation());
  ThrowIfInvalid(options.deformer.frames, FlagsOfContact());
  ThrowIfInvalid(options.deformer.solver, FlagsOfSolver());
}

void CheckValid(const RestSeparationOptions& options) {
  ThrowIfInvalid(options.prepare, FlagsOfPreparation());
  ThrowIfInvalid(options, FlagsOfContact());
}

void SetGap(double gap, CertifiedContactOptions* options) {
  if (gap > kLargestGap) {
    throw InputError(
        "--gap", "is " + std::to_string(gap), "allowed: above 0, at most 0.5");
  }
  options->step.gap = gap;
  options->separation.cell.margin = kMarginByGap * gap;
}

}  // namespace musclewarp
