// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_push_options.h"

#include "musclewarp/base/option_check.h"

namespace musclewarp {

bool BonePushOptions::IsValid(std::string* error) const {
  return OptionCheck("BonePushOptions", error)
      .IsAtLeast("clearance", clearance, 0)
      .IsAbove("onset", onset, 0)
      .IsAbove("relative_stiffness", relative_stiffness, 0)
      .IsAtLeast("drag", drag, 0)
      .IsAtLeast("max_lag", max_lag, 0)
      .IsAtLeast("samples_per_coarse_vertex", samples_per_coarse_vertex, 1)
      .IsAtLeast("steps_per_pose", steps_per_pose, 1)
      .IsAbove("field_spacing", field_spacing, 0)
      .is_valid();
}

}  // namespace musclewarp
