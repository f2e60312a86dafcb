// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/rest_pose.h"

#include <gtest/gtest.h>

#include "support/osim_models.h"

namespace musclewarp {
namespace {

// The solver stops where steps no longer change anything: 1e-7 of a radian and
// of the mm that residuals are in.
constexpr double kTolerance = 1e-6;

// An angle that is off by kTolerance moves a frame 400 mm away by this, mm.
constexpr double kDistance = 1e-3;

// A leg whose frames lie on each other at the coordinates of the knee's frame
// on the shank: bodies as a scanner gives them.
Model Scanned(const std::string& orientation, const std::string& place) {
  std::string text = Model4(Joint4("BallJoint", "a b c"));
  const std::string at = "<translation>0 0 0</translation><orientation>0 0 0";
  text.replace(
      text.find(at),
      at.size(),
      "<translation>" + place + "</translation><orientation>" + orientation);
  return ReadModel(Written("leg.osim", text));
}

TEST(RestPose, IsWhereTheFramesCoincide) {
  const Model model = Scanned("0.1 -0.2 0.3", "0 -0.4 0");
  const CoincidentPose pose = FindCoincidentPose(model, {1, 2});
  EXPECT_NEAR(pose.values[0], 0.1, kTolerance);
  EXPECT_NEAR(pose.values[1], -0.2, kTolerance);
  EXPECT_NEAR(pose.values[2], 0.3, kTolerance);
  EXPECT_LT(pose.distance, kDistance);
  EXPECT_LT(pose.angle, kTolerance);
}

TEST(RestPose, SaysWhatIsLeftWhereTheyCannot) {
  // The knee lies 10 mm lower on the shank than on the thigh.
  const Model model = Scanned("0 0 0", "0 -0.41 0");
  EXPECT_NEAR(FindCoincidentPose(model, {1, 2}).distance, 10, 0.01);
}

TEST(RestPose, OneBodyNeedsNoPose) {
  const Model model = Scanned("0.1 0 0", "0 -0.4 0");
  const CoincidentPose pose = FindCoincidentPose(model, {2});
  EXPECT_EQ(pose.values, DefaultValues(model));
  EXPECT_EQ(pose.distance, 0);
}

}  // namespace
}  // namespace musclewarp
