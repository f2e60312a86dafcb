// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/rest_settings.h"

namespace musclewarp {

void SetOptions(const RestSettings& settings,
                PrepareOptions* prepare,
                CertifiedContactOptions* contact,
                FrameRequirements* requirements,
                ReconstructionOptions* reconstruction) {
  contact->step.gap = settings.gap;
  prepare->repair.holes.max_perimeter = settings.max_hole;
  requirements->max_volume_loss = settings.max_loss;
  requirements->max_lost_area = settings.max_lost_area;
  requirements->max_lost_extent = settings.max_lost_extent;
  reconstruction->kind = settings.remake == "never" ? ReconstructionKind::kNever
                                                    : ReconstructionKind::kAuto;
}

}  // namespace musclewarp
