// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/muscle_group/contact_callback.h"

#include <utility>

namespace musclewarp {

ContactCallback::ContactCallback(std::function<bool()> before_step,
                                 std::function<void()> after_step)
    : before_step_(std::move(before_step)),
      after_step_(std::move(after_step)) {}

ceres::CallbackReturnType ContactCallback::operator()(
    const ceres::IterationSummary& iteration) {
  trust_region_radius_ = iteration.trust_region_radius;
  if (iteration.iteration == 0) {
    has_changed_ = before_step_();
  } else if (iteration.step_is_successful) {
    after_step_();
    has_changed_ = true;
  }
  return has_changed_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                      : ceres::SOLVER_CONTINUE;
}

bool ContactCallback::TakeHasChanged() {
  return std::exchange(has_changed_, false);
}

}  // namespace musclewarp
