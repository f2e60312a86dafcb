// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/muscle_group/contact_callback.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <gtest/gtest.h>

#include <vector>

namespace musclewarp {
namespace {

// The minimum is 0; a step goes all the way.
struct Parabola {
  template <typename T>
  bool operator()(const T* x, T* residual) const {
    residual[0] = x[0];
    return true;
  }
};

class ContactCallbackTest : public ::testing::Test {
 protected:
  ContactCallbackTest() {
    problem_.AddResidualBlock(
        new ceres::AutoDiffCostFunction<Parabola, 1, 1>(new Parabola),
        nullptr,
        &x_);
    options_.update_state_every_iteration = true;
    options_.logging_type = ceres::SILENT;
  }

  double x_ = 8;
  ceres::Problem problem_;
  ceres::Solver::Options options_;
};

TEST_F(ContactCallbackTest, CeresIgnoresWhatACallbackWrites) {
  // Why the solve has to end: this one writes and goes on.
  struct Writer : public ceres::IterationCallback {
    ceres::CallbackReturnType operator()(
        const ceres::IterationSummary& iteration) override {
      if (iteration.iteration == 1) *x = -100;
      return ceres::SOLVER_CONTINUE;
    }
    double* x;
  } writer;
  writer.x = &x_;
  options_.callbacks = {&writer};
  ceres::Solver::Summary summary;
  ceres::Solve(options_, &problem_, &summary);
  EXPECT_NEAR(x_, 0, 1e-3);
}

TEST_F(ContactCallbackTest, TheNextStepStartsFromWhatContactLeft) {
  // Contact takes half of every step back.
  double state = x_;
  std::vector<double> starts;
  ContactCallback callback(
      [&] {
        starts.push_back(x_);
        return false;
      },
      [&] { state += 0.5 * (x_ - state); });
  options_.callbacks = {&callback};
  double radius = options_.initial_trust_region_radius;
  for (int k = 0; k < 4; ++k) {
    x_ = state;
    options_.initial_trust_region_radius = radius;
    ceres::Solver::Summary summary;
    ceres::Solve(options_, &problem_, &summary);
    EXPECT_EQ(summary.termination_type, ceres::USER_SUCCESS);
    EXPECT_TRUE(callback.TakeHasChanged());
    EXPECT_FALSE(callback.TakeHasChanged());
    // Good steps widen the region, and it stays so.
    EXPECT_GT(callback.trust_region_radius(), radius);
    radius = callback.trust_region_radius();
  }
  ASSERT_EQ(starts.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    // A region of 1e4 shortens steps by as much.
    EXPECT_NEAR(starts[k], 8 * std::pow(0.5, k), 1e-3);
  }
}

TEST_F(ContactCallbackTest, EndsBeforeTheFirstStepIfTheStartChanged) {
  ContactCallback callback([] { return true; }, [] { FAIL(); });
  options_.callbacks = {&callback};
  ceres::Solver::Summary summary;
  ceres::Solve(options_, &problem_, &summary);
  EXPECT_TRUE(callback.TakeHasChanged());
  EXPECT_EQ(x_, 8);
}

}  // namespace
}  // namespace musclewarp
