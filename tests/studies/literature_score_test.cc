// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/literature_score.h"

#include <gtest/gtest.h>

#include <string>

namespace musclewarp {
namespace {

MeasuredArm Measured(double angle, double arm, const std::string& source) {
  MeasuredArm measured;
  measured.joint = "knee";
  measured.coordinate = "flexion";
  measured.muscle = "gracilis";
  measured.angle_deg = angle;
  measured.arm_mm = arm;
  measured.source = source;
  return measured;
}

// A run over knee_angle_r from 0 to 90 degrees whose path has the arm `at_0`
// first and `at_90` last; carried arms are 2 mm below those of the path.
std::vector<FrameFigures> Frames(double at_0, double at_90, double sign = 1) {
  std::vector<FrameFigures> frames;
  for (int i = 0; i <= 9; ++i) {
    FrameFigures& frame = frames.emplace_back();
    frame.coordinates["knee_angle_r"] = sign * 10 * i;
    const double arm = sign * (at_0 + (at_90 - at_0) * i / 9);
    MuscleFigures muscle;
    muscle.name = "gracilis_r";
    for (const char* line : {"a", "b"}) {
      const double aside = line[0] == 'a' ? 1 : -1;
      muscle.path_lengths[line] = 300;
      frame.path_moment_arms[line]["knee_angle_r"] = arm + aside;
      muscle.line_moment_arms[line]["knee_angle_r"] = arm + aside - 2 * sign;
    }
    frame.muscles.push_back(muscle);
  }
  return frames;
}

ArmsOfRun Arms(const std::vector<FrameFigures>& frames) {
  ArmsOfRun arms;
  AddArms({"knee_angle_r"}, frames, &arms);
  return arms;
}

ScoredMuscle OnlyRow(const MeasuredArms& measured,
                     const std::vector<FrameFigures>& frames) {
  const auto scored = ScoreArms(measured, Arms(frames), frames);
  EXPECT_EQ(scored.size(), 1u);
  return scored.empty() ? ScoredMuscle() : scored[0];
}

TEST(LiteratureScore, HoldsArmsThatAreTheMeasuredOnes) {
  const MeasuredArms measured = {
      {Measured(0, 20, "A"), Measured(45, 30, "A"), Measured(90, 40, "A")}};
  const ScoredMuscle row = OnlyRow(measured, Frames(20, 40));
  EXPECT_EQ(row.muscle, "gracilis_r");
  EXPECT_EQ(row.values, 3);
  EXPECT_EQ(row.studies, 1);
  EXPECT_NEAR(row.path.low_mm, 20, 1e-12);
  EXPECT_NEAR(row.path.high_mm, 40, 1e-12);
  EXPECT_NEAR(row.carried.low_mm, 18, 1e-12);
  EXPECT_TRUE(row.path.Holds());
  EXPECT_TRUE(row.carried.Holds());
}

TEST(LiteratureScore, CountsWhatIsOutsideOfTheBand) {
  const MeasuredArms measured = {{Measured(0, 20, "A"), Measured(90, 40, "A")}};
  // 30 % around a single study: 14 to 26, and 28 to 52.
  const ScoredMuscle row = OnlyRow(measured, Frames(25, 60));
  EXPECT_EQ(row.path.inside, 0.5);
  EXPECT_TRUE(row.path.has_sign);
  EXPECT_EQ(row.path.has_trend, true);
  EXPECT_FALSE(row.path.Holds());
}

TEST(LiteratureScore, WidensTheRangeOfSeveralStudiesByATenth) {
  const MeasuredArms measured = {
      {Measured(45, 20, "A"), Measured(46, 30, "B")}};
  EXPECT_EQ(OnlyRow(measured, Frames(32.5, 32.5)).path.inside, 1);
  EXPECT_EQ(OnlyRow(measured, Frames(33.5, 33.5)).path.inside, 0);
}

TEST(LiteratureScore, TellsSignAndTrendApart) {
  const MeasuredArms measured = {{Measured(0, 20, "A"), Measured(90, 40, "A")}};
  const ScoredMuscle falling = OnlyRow(measured, Frames(26, 20));
  EXPECT_TRUE(falling.path.has_sign);
  EXPECT_EQ(falling.path.has_trend, false);
  const ScoredMuscle turned = OnlyRow(measured, Frames(-20, -10));
  EXPECT_FALSE(turned.path.has_sign);
  EXPECT_EQ(turned.path.has_trend, true);
  const MeasuredArms flat = {{Measured(0, 20, "A"), Measured(90, 21, "A")}};
  EXPECT_EQ(OnlyRow(flat, Frames(26, 20)).path.has_trend, std::nullopt);
}

TEST(LiteratureScore, DoesNotDependOnTheSignOfTheCoordinate) {
  const MeasuredArms measured = {{Measured(0, 20, "A"), Measured(90, 40, "A")}};
  const ScoredMuscle row = OnlyRow(measured, Frames(20, 40, -1));
  EXPECT_TRUE(row.turned);
  EXPECT_TRUE(row.path.Holds());
}

TEST(LiteratureScore, LeavesOutWhatIsNotOfTheMotion) {
  MeasuredArms measured = {{Measured(120, 20, "A"), Measured(45, 99, "B")}};
  measured.arms[1].condition = "MVC";
  MeasuredArm without_angle = Measured(0, 20, "C");
  without_angle.angle_deg.reset();
  measured.arms.push_back(without_angle);
  const auto frames = Frames(20, 40);
  EXPECT_TRUE(ScoreArms(measured, Arms(frames), frames).empty());
}

}  // namespace
}  // namespace musclewarp
