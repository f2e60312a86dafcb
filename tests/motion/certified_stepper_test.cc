// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/certified_stepper.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "musclewarp/motion/certified_motion.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

class CertifiedStepperTest : public ::testing::Test {
 protected:
  CertifiedStepperTest()
      : scene_(PreparedSmallScene()),
        solver_(ReferenceSolvers().single),
        certified_(PrepareCertifiedScene(
            scene_, SceneMeshes(scene_), {}, {}, solver_, {})),
        mover_{scene_, certified_, pre_rotation_, solver_} {}

  // The rest pose with all muscles 12 mm aside, where nothing is in their way.
  ContactState Aside() const {
    ContactState state = certified_.rest;
    for (Points& points : state.points) {
      points.rowwise() += Eigen::RowVector3d(0, 12, 0);
    }
    return state;
  }

  // How far the farthest vertex is from where its coarse mesh has it, mm.
  static double LargestOffset(const ContactState& state) {
    double largest = 0;
    for (size_t i = 0; i < state.points.size(); ++i) {
      largest = std::max(
          largest,
          (state.points[i] - state.targets[i]).rowwise().norm().maxCoeff());
    }
    return largest;
  }

  const PreparedScene scene_;
  const PreRotationOptions pre_rotation_;
  const MuscleSolver solver_;
  const CertifiedScene certified_;
  const MotionContext mover_;
  const ScenePose pose_ = certified_.rest.pose;
};

TEST_F(CertifiedStepperTest, SettlingStepsReachFartherWhileThereIsFarToGo) {
  AdvanceOptions advance;
  advance.step = certified_.options.step;
  advance.max_settling_steps = 6;
  advance.settling_tolerance = 0.05;
  ContactState state = Aside();
  AdvanceToPose(mover_, advance, pose_, /*at=*/1, {}, &state);
  // By the reach of 1 mm in each step.
  EXPECT_GT(LargestOffset(state), 5.9);

  advance.reach_growth = 1.5;
  advance.max_reach = 4;
  state = Aside();
  AdvanceToPose(mover_, advance, pose_, /*at=*/1, {}, &state);
  // 1 + 1.5 + 2.25 + 3.375 + 4 mm are more than 12; the rest is less than
  // one reach.
  EXPECT_LT(LargestOffset(state), 1);
}

TEST_F(CertifiedStepperTest, SettlingEndsWhereNothingMoves) {
  AdvanceOptions advance;
  advance.step = certified_.options.step;
  advance.max_settling_steps = 6;
  advance.settling_tolerance = 0.05;
  ContactState state = certified_.rest;
  EXPECT_EQ(AdvanceToPose(mover_, advance, pose_, /*at=*/1, {}, &state).steps,
            1);
}

// A volume that is not a number reaches every coordinate by way of the
// pressure.
TEST_F(CertifiedStepperTest, AStepThatIsNotFiniteIsNeverTaken) {
  AdvanceOptions advance;
  advance.step = certified_.options.step;
  advance.max_settling_steps = 2;
  ContactState state = Aside();
  state.withheld.assign(state.points.size(),
                        std::numeric_limits<double>::quiet_NaN());
  const AdvanceSummary summary =
      AdvanceToPose(mover_, advance, FlexedPose(0.2), /*at=*/0, {}, &state);
  EXPECT_EQ(summary.given_up, GivenUp::kNotFinite);
  EXPECT_EQ(summary.reached, 0);
  for (const Points& points : state.points) EXPECT_TRUE(points.allFinite());

  // At the pose there is nothing to be given up.
  state = Aside();
  state.withheld.assign(state.points.size(),
                        std::numeric_limits<double>::quiet_NaN());
  const ContactState before = state;
  AdvanceToPose(mover_, advance, pose_, /*at=*/1, {}, &state);
  EXPECT_EQ(state.points, before.points);
}

}  // namespace
}  // namespace musclewarp
