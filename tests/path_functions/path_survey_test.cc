// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/path_survey.h"

#include <gtest/gtest.h>

#include <cmath>

namespace musclewarp {
namespace {

// 100 + a x + b x^2, from -1 to 1; the arm is -(a + 2 b x).
PathFunction Parabola(double a, double b) {
  PathFunction path;
  path.coordinates = {0};
  path.exponents.resize(3, 1);
  path.exponents << 0, 1, 2;
  path.coefficients = Eigen::Vector3d(100, a, b);
  path.low = Eigen::VectorXd::Constant(1, -1);
  path.high = Eigen::VectorXd::Constant(1, 1);
  return path;
}

TEST(PathSurvey, CountsLinesOnWhichAnArmChangesItsSign) {
  const PathSurvey changes = SurveyPath(Parabola(0, 20), 50, 1);
  EXPECT_EQ(changes.lines, 50);
  EXPECT_EQ(changes.lines_with_sign_change, 50);
  EXPECT_EQ(changes.most_sign_changes, 1);
  EXPECT_EQ(changes.jumps, 0);
  EXPECT_NEAR(changes.steepest, 40, 1e-9);
  EXPECT_EQ(SurveyPath(Parabola(-50, 20), 50, 1).lines_with_sign_change, 0);
  // An arm below 1 mm has no sign.
  EXPECT_EQ(SurveyPath(Parabola(0, 0.4), 50, 1).lines_with_sign_change, 0);
}

// Arms of 10 mm that are 14 mm behind a place, as where a wrapped path slips.
TEST(PathSurvey, FindsAJump) {
  const Eigen::VectorXd low = Eigen::VectorXd::Constant(1, -1);
  const Eigen::VectorXd high = Eigen::VectorXd::Constant(1, 1);
  const auto stepped = [](const Eigen::VectorXd& at) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, at[0] < 0.123 ? 10 : 14);
  };
  EXPECT_EQ(SurveyArms(stepped, low, high, 50, 1).jumps, 50);
}

// A steep arm, and one that turns back within a piece, are none.
TEST(PathSurvey, TakesNoSmoothChangeForAJump) {
  const Eigen::VectorXd low = Eigen::VectorXd::Constant(1, -1);
  const Eigen::VectorXd high = Eigen::VectorXd::Constant(1, 1);
  for (const double rate : {10.0, 60.0, 150.0}) {
    const auto wave = [&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
      return Eigen::VectorXd::Constant(1, 20 * std::sin(rate * at[0]));
    };
    EXPECT_EQ(SurveyArms(wave, low, high, 50, 1).jumps, 0) << rate;
  }
}

TEST(PathSurvey, IsThatOfItsSeed) {
  const PathFunction path = Parabola(3, 20);
  EXPECT_EQ(SurveyPath(path, 50, 2).steepest, SurveyPath(path, 50, 2).steepest);
}

TEST(PathSurvey, OfARangeOfOnePointFindsNothing) {
  PathFunction path = Parabola(3, 20);
  path.high = path.low;
  const PathSurvey survey = SurveyPath(path, 10, 1);
  EXPECT_EQ(survey.jumps, 0);
  EXPECT_EQ(survey.lines_with_sign_change, 0);
}

}  // namespace
}  // namespace musclewarp
