// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/step.h"
#include "musclewarp/motion/motion_context.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// A step of certified contact to a pose: a solve without contact predicts the
// coarse meshes, and Step() moves the muscles there between separating planes,
// with a second coarse solve that includes contact rows.
struct PoseStep {
  StepOptions options;
  ScenePose pose;

  // True for a settling step: `pose` is that of the state before, and the solve
  // without contact is skipped.
  bool is_settling = false;

  double max_push = kInfinity;  // mm, see StepGoal

  // By muscle: whether it keeps its shape in a settling step. Empty: all move.
  std::vector<char> is_still = {};

  // By muscle: its reach, mm. Empty: that of the options.
  std::vector<double> reaches = {};
};

// The summaries of the solves that produced a state, by muscle, in the order of
// contact.
struct StepSolves {
  std::vector<SolverSummary> free;  // without contact
  std::vector<SolverSummary> all;   // both together (MergedSummary)

  explicit StepSolves(size_t num_muscles = 0)
      : free(num_muscles), all(num_muscles) {}
};

// The state after a step, and the summaries of the step and its solves.
struct PoseStepResult {
  ContactState state;
  StepSummary summary;
  StepSolves solves;
};

// Takes a step from `before`. `solves`: the solves that produced `before`; a
// settling step reuses that without contact. Precondition (CHECKed): the
// options are valid.
PoseStepResult TakeStep(const MotionContext& context,
                        const PoseStep& step,
                        const ContactState& before,
                        const StepSolves& solves);

// Moves a scene to a pose without contact: coarse meshes keep their current
// displacement by contact, and fine vertices their offsets.
PoseStepResult GoWithoutContact(const MotionContext& context,
                                const ScenePose& pose,
                                const ContactState& before);

}  // namespace musclewarp
