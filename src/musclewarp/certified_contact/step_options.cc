// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/step_options.h"

#include "musclewarp/base/option_check.h"

namespace musclewarp {

bool PlaneSearchOptions::IsValid(std::string* error) const {
  return OptionCheck("PlaneSearchOptions", error)
      .IsWithin("search_fraction", search_fraction, 0, 1)
      .IsWithin("overlooked_fraction", overlooked_fraction, 0, 0.9)
      .IsAtLeast("max_planes_per_triangle", max_planes_per_triangle, 1)
      .IsAtLeast("kept_slack", kept_slack, 0)
      .IsAtLeast("sheet_distance", sheet_distance, 0)
      .IsWithin("min_facing", min_facing, 0, 1)
      .is_valid();
}

bool RelaxationOptions::IsValid(std::string* error) const {
  return OptionCheck("RelaxationOptions", error)
      .IsAbove("smoothing_length", smoothing_length, 0)
      .IsAtLeast("strain_hardening", strain_hardening, 0)
      .IsAtLeast("stretch_limit", stretch_limit, 1)
      .IsAtLeast("rope_factor", rope_factor, 0)
      .IsWithin("pressure_gain", pressure_gain, 0, 1)
      .IsAtLeast("full_sweep_interval", full_sweep_interval, 1)
      .IsAtLeast("level_interval", level_interval, 1)
      .IsAbove("max_push", max_push, 0)
      .IsWithin("room_decay", room_decay, 0, 1)
      .IsAtLeast("room_tolerance", room_tolerance, 0)
      .IsAbove("violation_weight", violation_weight, 0)
      .IsAtLeast("bone_turns", bone_turns, 1)
      .IsAtLeast("contact_distance", contact_distance, 0)
      .is_valid();
}

bool VolumeOptions::IsValid(std::string* error) const {
  return OptionCheck("VolumeOptions", error)
      .IsAbove("tolerance", tolerance, 0)
      .IsAtLeast("max_steps", max_steps, 1)
      .IsAbove("max_move", max_move, 0)
      .IsAtLeast("smoothing_passes", smoothing_passes, 0)
      .is_valid();
}

bool DefectOptions::IsValid(std::string* error) const {
  return OptionCheck("DefectOptions", error)
      .IsWithin("sheet_fraction", sheet_fraction, 0, 1)
      .IsAtLeast("stiffening", stiffening, 1)
      .IsAtLeast("max_stiffness", max_stiffness, 1)
      .IsWithin("unfolded_height", unfolded_height, 0, 1)
      .IsWithin("max_folded_fraction", max_folded_fraction, 0, 1)
      .is_valid();
}

bool StepOptions::IsValid(std::string* error) const {
  return OptionCheck("StepOptions", error)
             .IsAbove("gap", gap, 0)
             .IsWithin("gap", gap, 0, kLargestGap)
             .IsAbove("reach", reach, gap)
             .IsAtLeast("sweeps", sweeps, 1)
             .IsAtLeast("repair_sweeps", repair_sweeps, 1)
             .IsAtLeast("max_rounds", max_rounds, 1)
             .IsAtLeast("max_polishing_rounds", max_polishing_rounds, 0)
             .is_valid() &&
         planes.IsValid(error) && relaxation.IsValid(error) &&
         volume.IsValid(error) && defects.IsValid(error);
}

}  // namespace musclewarp
