// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/plane_set.h"
#include "musclewarp/certified_contact/relaxation.h"
#include "musclewarp/certified_contact/step_options.h"

namespace musclewarp {

struct RestoredVolumes {
  std::vector<Points> points;  // of the muscles, #V x 3, mm
  double worst_error = 0;      // relative, over the muscles
};

// Makes the volume of every muscle exact again after a relaxation: vertices
// that neither a plane nor a bone holds move along their normals, those beside
// held ones less, and all of them stay in their half-spaces. As in the paper,
// vertices in contact take no part (section 3.3). An error remains if planes
// hold too much of a muscle, or the steps run out.
RestoredVolumes RestoreVolumes(const StepOptions& options,
                               const ContactStep& step,
                               const RelaxedPoints& relaxed,
                               PlaneSet* planes);

}  // namespace musclewarp
