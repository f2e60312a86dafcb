// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/certified_contact/step.h"
#include "musclewarp/motion/given_up.h"
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
  // few steps and continues with shorter ones, at most `max_returns` times.
  int max_returns = 0;

  // A step of the shortest length is retried with the reach multiplied by
  // `reach_growth`, up to `max_reach`. The same applies to the step after a
  // settling step without defects that moved muscles by more than the reach.
  double reach_growth = 1;
  double max_reach = 0;  // mm

  // At the pose, at most `max_settling_steps` settling steps follow, until all
  // muscles have settled within the tolerance, mm (SettlingMuscles).
  int max_settling_steps = 0;
  double settling_tolerance = 0;

  // True if settling steps follow even if contact pushes no muscle by the
  // reach.
  bool always_settles = false;

  // True if `state` is a rest pose just after its separation, from which
  // vertices have far to go: steps then reach as far as the last one moved
  // muscles, times `reach_growth`, and self-crossings do not count as
  // crossings. The first steps unfold muscles if `step` says so, as long as
  // that leaves fewer self-crossings.
  bool relaxes_rest = false;

  // No step to the pose starts after so many in a row that were accepted though
  // triangles cross; 0: no limit. Every accepted step brings the motion farther
  // by the shortest length at least, and what is tried before one is bounded by
  // the halvings, the backtracks and the reach: without a limit the motion ends
  // all the same.
  int max_stuck_steps = 0;

  // No step starts after this time, s; 0: no limit.
  double timeout_s = 0;

  StepCallback on_step;  // called after every step, may be empty
};

// The outcome of AdvanceToPose.
struct AdvanceSummary {
  int steps = 0;       // including rejected ones
  double reached = 1;  // the fraction of the motion, with contact

  GivenUp given_up = GivenUp::kNot;

  // The last state without crossing triangles, if the final state has some or
  // the motion was given up.
  std::optional<ContactState> last_clean;

  // The solves of the last step, by muscle, in the order of contact.
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
// `on_progress` may be empty, and may throw: `state` is then the result of the
// last accepted step.
AdvanceSummary AdvanceToPose(const MotionContext& context,
                             const AdvanceOptions& options,
                             const ScenePose& goal,
                             double at,
                             const ProgressCallback& on_progress,
                             ContactState* state);

}  // namespace musclewarp
