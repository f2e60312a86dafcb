// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/plane_set.h"
#include "musclewarp/certified_contact/relaxation.h"
#include "musclewarp/certified_contact/step_options.h"

namespace musclewarp {

// The result of RestoreVolumes.
struct RestoredVolumes {
  std::vector<Points> points;  // of the muscles, #V x 3, mm
  double worst_error = 0;      // relative, over the muscles

  // By muscle: the volume that was missing before, mm^3, and whether
  // VolumeOptions::max_move has ended the restoration.
  std::vector<double> missing;
  std::vector<char> is_limited;
};

// Restores the volume of every muscle after a relaxation: vertices held by
// neither a plane nor a bone move along their normals, less so next to held
// ones, and all stay in their half-spaces. As in the paper, vertices in contact
// do not take part (section 3.3). An error remains if planes hold too much of a
// muscle, after VolumeOptions::max_steps steps, and at VolumeOptions::max_move.
RestoredVolumes RestoreVolumes(const StepOptions& options,
                               const ContactStep& step,
                               const RelaxedPoints& relaxed,
                               PlaneSet* planes);

}  // namespace musclewarp
