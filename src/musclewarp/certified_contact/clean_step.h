// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/certified_contact/contact_relaxation.h"

namespace musclewarp {

// Lets the coarse meshes make way for what vertices meet in a relaxation.
// Returns where they bring all vertices, the targets of what is left to single
// ones: by muscle, #V x 3.
using CoarseContact =
    std::function<std::vector<Points>(const ContactRelaxation& relaxation)>;

struct CleanStepOptions {
  ContactRelaxationOptions relaxation;
  // Rounds of sweeps and exact tests before a step is given up.
  int max_rounds = 6;
  // Another round is made if a vertex is nearer to an obstacle than this part
  // of the gap.
  double least_gap = 0.2;

  bool IsValid(std::string* error) const;
};

struct CleanStepSummary {
  bool is_clean = false;
  int rounds = 0;
  int crossing_pairs = 0;   // of two meshes, in the last round
  double violation = 0;     // of a plane, mm
  double volume_error = 0;  // relative
};

// Moves `state`, which is clean, to where `next` has bones and targets, so that
// it is clean there (ContactRelaxation). If it is not, the step was too far, or
// there is no room: what was reached is in `next.points`, and `state` is as it
// was. Without `coarse_contact` the targets are as they are.
CleanStepSummary StepCleanly(const CleanStepOptions& options,
                             const std::vector<ContactMesh>& muscles,
                             const std::vector<const TriangleBvh*>& rest_bones,
                             const CoarseContact& coarse_contact,
                             ContactState* next,
                             ContactState* state);

}  // namespace musclewarp
