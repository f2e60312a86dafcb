// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/iteration_callback.h>

#include <functional>

namespace musclewarp {

// Runs contact inside ceres::Solve (paper section 3): the initial fix before
// the first step, rollback and masking after every successful step.
//
// Ceres keeps its own copy of the parameters and ignores what a callback writes
// into parameter blocks. This callback therefore ends the solve whenever
// contact has changed the state, and the driver (muscle_group_solver.cc) writes
// that state to the blocks and calls ceres::Solve again:
//
//   ContactCallback callback([&] { return contact.Start(&states); },
//                            [&] { contact.AfterStep(alpha, &states); });
//   options.callbacks = {&callback};
//   options.update_state_every_iteration = true;
//   while (...) {
//     ... write the states to the parameter blocks ...
//     ceres::Solve(options, &problem, &summary);
//     if (!callback.TakeHasChanged()) ... Ceres found no step to take ...
//   }
class ContactCallback : public ceres::IterationCallback {
 public:
  // `before_step` is called at the start of every solve and returns whether it
  // changed the state; `after_step` is called after every successful step and
  // is taken to change the state always. Both read the parameter blocks, for
  // which Solver::Options::update_state_every_iteration must be true, and must
  // write the new state elsewhere.
  ContactCallback(std::function<bool()> before_step,
                  std::function<void()> after_step);

  // Called by Ceres. Never aborts: a solve ended by contact counts as success.
  ceres::CallbackReturnType operator()(
      const ceres::IterationSummary& iteration) override;

  // Returns whether contact ended the last solve, and resets the answer to
  // false.
  bool TakeHasChanged();

  // The trust region radius of the last iteration, with which the next solve
  // should start.
  double trust_region_radius() const { return trust_region_radius_; }

 private:
  const std::function<bool()> before_step_;
  const std::function<void()> after_step_;
  bool has_changed_ = false;
  double trust_region_radius_ = 0;
};

}  // namespace musclewarp
