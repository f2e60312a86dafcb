// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/step.h"
#include "musclewarp/motion/motion_context.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// A step of a scene in contact to a pose: a solve without contact, from which
// the coarse meshes are predicted, and a step of certified contact (Step), in
// which they are solved once more to make way for its planes.
struct PoseStep {
  StepOptions options;
  ScenePose pose;

  // True if the muscles settle where they are: `pose` is that of the state
  // before, and there is no solve without contact.
  bool is_settling = false;

  double max_push = kInfinity;  // mm, see StepGoal
};

// The summaries of the solves that a state comes from, by muscle, in the order
// of contact.
struct StepSolves {
  std::vector<SolverSummary> free;  // without contact
  std::vector<SolverSummary> all;   // both together (MergedSummary)

  explicit StepSolves(size_t num_muscles = 0)
      : free(num_muscles), all(num_muscles) {}
};

struct PoseStepResult {
  ContactState state;
  StepSummary summary;
  StepSolves solves;
};

// Takes a step from `before`, which came from the solves `solves`: if muscles
// settle, there is no other solve without contact. Precondition (CHECKed): the
// options are valid.
PoseStepResult TakeStep(const MotionContext& context,
                        const PoseStep& step,
                        const ContactState& before,
                        const StepSolves& solves);

// Returns the state of a scene that goes to a pose without contact: the coarse
// meshes keep the displacement by contact that they have, and single vertices
// their offsets.
PoseStepResult GoWithoutContact(const MotionContext& context,
                                const ScenePose& pose,
                                const ContactState& before);

}  // namespace musclewarp
