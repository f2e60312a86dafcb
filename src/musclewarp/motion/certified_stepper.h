// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/base/progress.h"
#include "musclewarp/certified_contact/step.h"
#include "musclewarp/motion/mover.h"
#include "musclewarp/motion/recorded_step.h"
#include "musclewarp/motion/step_length.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// The stepper of certified contact. The rest pose is relaxed and poses are
// reached by the same steps, with other options:
//
//   const WalkSummary walk = Walk(mover, options, pose, /*at=*/0, {}, &state);

// How a scene goes from one state to another.
struct WalkOptions {
  StepOptions step;

  StepLengthOptions length;  // of steps to the pose

  // Where triangles cross even after the shortest step, the walk goes back a
  // few steps for shorter ones all the way, so many times.
  int max_returns = 0;

  // A step that cannot be shorter is tried again with more reach. A settling
  // step gets more of it if muscles moved by all that the one before had.
  double reach_growth = 1;
  double max_reach = 0;  // mm

  // Once the pose is reached, steps go on there until no more than one vertex
  // in five hundred moves by more than the tolerance, mm.
  int max_settling_steps = 0;
  double settling_tolerance = 0;

  // If true, a step may leave more crossings of a muscle with itself.
  bool accepts_self_crossings = false;

  // No step begins later than this, s; 0: no limit.
  double timeout_s = 0;

  StepCallback on_step;  // called after every step, may be empty
};

// How a walk ended.
struct WalkSummary {
  int steps = 0;              // including those that were given up
  double reached = 1;         // the share of the way that was gone
  bool is_timed_out = false;  // then the last part was gone without contact

  // The last state in which nothing crossed, if something does at the end.
  std::optional<ContactState> last_clean;

  // Of the last step, by muscle, in the order of contact.
  std::vector<SolverSummary> solves;
};

// Moves on from `state` to a pose, and settles there. `at` is the share of the
// way that is already done: 1 if the state is in that pose.
//
// What follows a step is in step_remedies.h: one that pushes muscles too far is
// shortened (StepLength), and one after which triangles cross is halved. If it
// cannot be, muscles are in a dead end: the walk goes back a few steps, and on
// from there by steps a quarter as long. If it may not go back again, the step
// is tried with more reach. If that does not help either, it ends the settling;
// on the way to a pose it is taken all the same, as what follows may part the
// triangles, but nothing more is tried until they have parted.
//
// `on_progress` may be empty, and may throw: the state is then as the last step
// has left it.
WalkSummary Walk(const Mover& mover,
                 const WalkOptions& options,
                 const ScenePose& goal,
                 double at,
                 const ProgressCallback& on_progress,
                 ContactState* state);

}  // namespace musclewarp
