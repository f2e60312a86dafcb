// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/path_survey.h"

#include <gtest/gtest.h>

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

TEST(PathSurvey, FindsAJump) {
  // So steep a wave in the middle of the range is one to all who use it.
  PathFunction path = Parabola(0, 0);
  path.exponents << 0, 1, 12;
  path.coefficients = Eigen::Vector3d(100, 0, 0);
  EXPECT_EQ(SurveyPath(path, 20, 1).jumps, 0);
  // 1e9 x^12 of a range of 1e-3: nothing but a step at both ends.
  path.coefficients[2] = 1e40;
  path.low.setConstant(-1e-3);
  path.high.setConstant(1e-3);
  const PathSurvey survey = SurveyPath(path, 20, 1);
  EXPECT_GT(survey.steepest, 0);
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
