// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/certified_contact/step.h"
#include "musclewarp/motion/motion_context.h"
#include "musclewarp/motion/recorded_step.h"
#include "musclewarp/motion/step_length.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// The stepper of certified contact: it relaxes the rest pose and moves a scene
// to a pose by the same steps, with different options.
//
//   const AdvanceSummary summary =
//       AdvanceToPose(context, options, pose, /*at=*/0, {}, &state);

// The control of the steps from one state to the next.
struct AdvanceOptions {
  StepOptions step;

  StepLengthOptions length;  // of steps to the pose

  // If triangles cross even after the shortest step, the solver backtracks a
  // few steps and continues with shorter ones, at most so many times.
  int max_returns = 0;

  // A step that cannot be shorter is tried again with more reach. A settling
  // step gets more of it if muscles moved by all that the one before had.
  double reach_growth = 1;
  double max_reach = 0;  // mm

  // At the pose, settling steps are taken until at most one vertex in five
  // hundred moves by more than the tolerance, mm.
  int max_settling_steps = 0;
  double settling_tolerance = 0;

  // If true, a step may leave more crossings of a muscle with itself.
  bool accepts_self_crossings = false;

  // No step begins later than this, s; 0: no limit.
  double timeout_s = 0;

  StepCallback on_step;  // called after every step, may be empty
};

// The outcome of AdvanceToPose.
struct AdvanceSummary {
  int steps = 0;              // including rejected ones
  double reached = 1;         // the fraction of the motion, in contact
  bool is_timed_out = false;  // the remainder was computed without contact

  // The last state in which nothing crossed, if something does at the end.
  std::optional<ContactState> last_clean;

  // Of the last step, by muscle, in the order of contact.
  std::vector<SolverSummary> solves;
};

// Moves `state` to a pose and settles it there. `at` is the fraction of the
// motion that `state` has reached: 1 if it is in that pose.
//
// step_remedies.h lists the responses to a step: a step that pushes muscles too
// far is shortened (StepLength), and one that leaves crossing triangles is
// halved. At the shortest length the solver backtracks a few steps and
// continues with steps a quarter as long; after `max_returns` backtracks it
// retries the step with a larger reach. If triangles still cross, settling
// ends; before the pose the step is accepted all the same, as later steps may
// separate the triangles, and no other remedy is tried until they have.
//
// `on_progress` may be empty, and may throw: the state is then as the last step
// has left it.
AdvanceSummary AdvanceToPose(const MotionContext& context,
                             const AdvanceOptions& options,
                             const ScenePose& goal,
                             double at,
                             const ProgressCallback& on_progress,
                             ContactState* state);

}  // namespace musclewarp
