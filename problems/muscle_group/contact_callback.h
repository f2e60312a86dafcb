// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/iteration_callback.h>

#include <functional>

namespace musclewarp {

// Runs contact inside ceres::Solve: the initial fix before the first step,
// rollback and masking after every step (paper section 3).
//
// Ceres ignores what a callback writes into parameter blocks. So this one ends
// the solve whenever contact has changed the state, and the driver calls
// ceres::Solve again from there (muscle_group_solver.h).
class ContactCallback : public ceres::IterationCallback {
 public:
  // `before_step` is called at the start of every solve, and tells whether it
  // has changed the state; `after_step` after every successful step. They read
  // the parameter blocks, for which
  // Solver::Options::update_state_every_iteration is needed, and keep what they
  // change elsewhere.
  ContactCallback(std::function<bool()> before_step,
                  std::function<void()> after_step);

  ceres::CallbackReturnType operator()(
      const ceres::IterationSummary& iteration) override;

  // Whether contact ended the last solve; if not, Ceres found nothing to do.
  // Forgets it.
  bool TakeHasChanged();

  // Of the last iteration, to be carried to the next solve.
  double trust_region_radius() const { return trust_region_radius_; }

 private:
  const std::function<bool()> before_step_;
  const std::function<void()> after_step_;
  bool has_changed_ = false;
  double trust_region_radius_ = 0;
};

}  // namespace musclewarp
