// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "musclewarp/deformer/deformer.h"

namespace musclewarp {

// What users choose about a Deformer: the flags of musclewarp-deform by their
// names, with texts and units as flags have them (scene_flags.cc explains
// each). The Python package has the same choices as keywords.
struct DeformerSettings {
  std::string solver = "ceres";
  std::string contact = "certified";
  std::string contact_level = "coarse";
  std::string attachments = "auto";
  std::string remake = "auto";
  double max_loss = FrameRequirements().max_volume_loss;
  double max_lost_area = FrameRequirements().max_lost_area;      // mm^2
  double max_lost_extent = FrameRequirements().max_lost_extent;  // mm
  double max_torn_patch = FrameRequirements().max_torn_patch;    // mm^2
  int max_iterations = 500;
  unsigned seed = 1;
  double max_hole = HoleLimits().max_perimeter;  // mm
  int coarse_vertices = 200;
  int bone_coarse_vertices = 1000;
  std::string laplacian = "area";
  double laplacian_length = 0;  // mm; 0: by the area of the muscle
  std::string lines = "tendon";
  double sample_spacing = 10;  // mm
  double skeleton_weight = 1;
  double attachment_weight = 8;
  double bending_weight = MuscleModelOptions().bending_weight;
  int auto_lines = 3;
  int fibres = 0;
  double gap = StepOptions().gap;  // mm
  int max_rounds = 6;
  double frame_timeout_s = CertifiedContactOptions::kNoClock;
  double max_step_turn = 20;  // degrees
  double max_step_move = 80;  // mm
  bool body_twist = true;
  std::string cache = "none";  // or a folder

  // Which of these lengths are in mm whatever the size of the body: those that
  // the user gave (length_options.h).
  std::set<std::string> lengths_in_mm;
};

// Returns the options that these choices mean, but for the key of the cache,
// which has to tell all choices of the caller apart. Throws InputError that
// names the flag for a text that is none of the allowed ones, and for a limit
// that no IsValid would find. Other values are left to CheckValid
// (option_flags.h).
DeformerOptions OptionsOf(const DeformerSettings& choices);

// Returns the folder that "none" or a folder means: none is empty.
std::string CacheFolderOf(const std::string& cache);

// Sets the limits of all solvers of a configuration. Throws InputError, naming
// --max_iterations, if it is below 1.
void SetIterationLimit(int max_iterations, SolverConfiguration* configuration);

}  // namespace musclewarp
