// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/clean_step.h"

namespace musclewarp {

bool CleanStepOptions::IsValid(std::string* error) const {
  if (max_rounds < 1 || !(least_gap > 0 && least_gap < 1)) {
    *error =
        "CleanStepOptions: allowed are max_rounds above 0 and 0 < least_gap < "
        "1";
    return false;
  }
  return relaxation.IsValid(error);
}

CleanStepSummary StepCleanly(const CleanStepOptions& options,
                             const std::vector<ContactMesh>& muscles,
                             const std::vector<const TriangleBvh*>& rest_bones,
                             const CoarseContact& coarse_contact,
                             ContactState* next,
                             ContactState* state) {
  CleanStepSummary summary;
  ContactRelaxation relaxation(
      options.relaxation, muscles, rest_bones, *state, *next);
  int sweeps = options.relaxation.sweeps;
  if (coarse_contact) {
    relaxation.Sweep(sweeps / 2);
    sweeps -= sweeps / 2;
    next->targets = coarse_contact(relaxation);
    relaxation.SetTargets(next->targets);
  }
  // Two muscles share a gap.
  const double allowed = (1 - options.least_gap) / 2 * options.relaxation.gap;
  while (!summary.is_clean && summary.rounds < options.max_rounds) {
    ++summary.rounds;
    relaxation.Sweep(summary.rounds == 1 ? sweeps
                                         : options.relaxation.repair_sweeps);
    summary.volume_error = relaxation.RestoreVolumes();
    summary.violation = relaxation.WorstViolation();
    const StateDefects defects = relaxation.AddDefects();
    summary.crossing_pairs = defects.crossing_pairs;
    // Planes on the wrong side of which a vertex is and folded triangles are
    // worth another round, but no reason to give up a step.
    const bool is_better_possible =
        summary.violation > allowed || defects.folded > 0;
    summary.is_clean =
        defects.crossing_pairs + defects.self_pairs == 0 &&
        (!is_better_possible || summary.rounds == options.max_rounds);
  }
  next->points = relaxation.points();
  if (summary.is_clean) *state = *next;
  return summary;
}

}  // namespace musclewarp
