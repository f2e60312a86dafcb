// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/motion_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "figures/some_figures.h"
#include "musclewarp/base/angles.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// Rounding of quotients of differences of values about 10.
constexpr double kRounding = 1e-11;

// l = 3 - 2 q + 0.5 q^2, so that -dl/dq = 2 - q.
double Length(double q) { return 3 - 2 * q + 0.5 * q * q; }

TEST(SeriesMomentArms, AreExactForParabolasEndsIncluded) {
  const std::vector<double> q = {-1, -0.5, 0.2, 0.4, 1.5};
  std::vector<double> lengths;
  for (const double value : q) lengths.push_back(Length(value));
  const auto arms = SeriesMomentArms(lengths, q);
  for (size_t i = 0; i < q.size(); ++i) {
    EXPECT_NEAR(arms[i], 2 - q[i], kRounding) << i;
  }
}

TEST(SeriesMomentArms, FollowAMotionThatStandsAndTurnsRound) {
  const std::vector<double> q = {0, 0, 0.1, 0.2, 0.2, 0.1, 0};
  std::vector<double> lengths;
  for (const double value : q) lengths.push_back(Length(value));
  const auto arms = SeriesMomentArms(lengths, q);
  for (size_t i = 0; i < q.size(); ++i) {
    // At the turn there is one side only: half a step times the bend off.
    EXPECT_NEAR(arms[i], 2 - q[i], 0.05 + kRounding) << i;
  }
  EXPECT_NEAR(arms[2], 1.9, kRounding);
}

TEST(SeriesMomentArms, HaveNothingToSayWithoutMotion) {
  EXPECT_THAT(SeriesMomentArms({1, 2}, {0.5, 0.5}), ElementsAre(0, 0));
  EXPECT_THAT(SeriesMomentArms({1}, {0.5}), ElementsAre(0));
  EXPECT_THAT(SeriesMomentArms({1, 3}, {0, 1}), ElementsAre(-2, -2));
}

// The coordinates "hip" and "knee", of which some move.
Scene LegScene(const std::vector<std::string>& moving) {
  auto poses = std::make_shared<ModelPoses>();
  for (const char* name : {"hip", "knee"}) {
    Coordinate coordinate;
    coordinate.name = name;
    poses->model.coordinates.push_back(coordinate);
  }
  for (const std::string& name : moving) {
    poses->moving_coordinates.push_back(poses->model.FindCoordinate(name));
  }
  Scene scene;
  scene.model = poses;
  return scene;
}

std::vector<FrameFigures> Frames() {
  std::vector<FrameFigures> frames;
  for (int i = 0; i < 3; ++i) {
    frames.push_back(SomeFigures(i));
    frames.back().coordinates = {{"hip", 10.0 * i}, {"knee", -5.0 * i}};
    frames.back().muscles[0].line_lengths["l"] = 100 + 2 * i;
  }
  return frames;
}

TEST(MotionTables, AreInMetres) {
  const StorageTable lengths = LengthTable(Frames());
  EXPECT_THAT(lengths.labels, ElementsAre("l", "l_path"));
  EXPECT_THAT(lengths.times, ElementsAre(0.1, 1.1, 2.1));
  EXPECT_DOUBLE_EQ(lengths.values(2, 0), 0.104);
  EXPECT_DOUBLE_EQ(lengths.values(2, 1), 0.101);
  const StorageTable volumes = VolumeTable(Frames());
  EXPECT_THAT(volumes.labels, ElementsAre("m"));
  EXPECT_NEAR(volumes.values(0, 0), 2e5 / 7 * 1e-9, 1e-18);
  const StorageTable fibres = FibreLengthTable(Frames());
  EXPECT_THAT(fibres.labels, ElementsAre("m_fibre_1", "m_fibre_2"));
  EXPECT_DOUBLE_EQ(fibres.values(1, 0), 0.051);
}

TEST(MotionTables, MomentArmsAreOfEveryCoordinate) {
  const StorageTable arms = MomentArmTable(Frames(), LegScene({"hip"}));
  EXPECT_THAT(arms.labels,
              ElementsAre("l.hip", "l.knee", "l_path.hip", "l_path.knee"));
  EXPECT_DOUBLE_EQ(arms.values(1, 0), 0.02 / 3);
  EXPECT_EQ(arms.values(1, 1), 0);
  EXPECT_DOUBLE_EQ(arms.values(1, 2), 0.025);
  EXPECT_DOUBLE_EQ(arms.values(2, 3), -0.003);
  const StorageTable fibres = FibreMomentArmTable(Frames(), LegScene({"hip"}));
  EXPECT_THAT(fibres.labels,
              ElementsAre("m_fibre_1.hip",
                          "m_fibre_1.knee",
                          "m_fibre_2.hip",
                          "m_fibre_2.knee"));
  EXPECT_DOUBLE_EQ(fibres.values(0, 0), 0.001 / 7);
  EXPECT_DOUBLE_EQ(fibres.values(0, 2), -0.002);
  // The record leaves out what moves no fibre.
  EXPECT_EQ(fibres.values(0, 1), 0);
  EXPECT_TRUE(MomentArmTable(Frames(), Scene()).labels.empty());
}

TEST(MotionTables, WithoutMomentArmsLengthsAreComparedIfOneCoordinateMoves) {
  std::vector<FrameFigures> frames = Frames();
  for (FrameFigures& frame : frames) {
    frame.muscles[0].line_moment_arms.clear();
    frame.muscles[0].fibre_moment_arms.clear();
  }
  const StorageTable arms = MomentArmTable(frames, LegScene({"hip"}));
  EXPECT_THAT(arms.labels, ElementsAre("l.hip", "l_path.hip", "l_path.knee"));
  // 2 mm longer for 10 degrees more.
  EXPECT_NEAR(arms.values(1, 0), -0.002 / RadiansOf(10), kRounding);
  EXPECT_THAT(FibreMomentArmTable(frames, LegScene({"hip"})).labels,
              ElementsAre("m_fibre_1.hip", "m_fibre_2.hip"));
  EXPECT_THAT(MomentArmTable(frames, LegScene({"hip", "knee"})).labels,
              ElementsAre("l_path.hip", "l_path.knee"));
}

TEST(MotionTables, BlanksInNamesAndTimesThatStandAreNoTrouble) {
  std::vector<FrameFigures> frames = Frames();
  for (FrameFigures& frame : frames) {
    frame.time = 0;
    frame.muscles[0].line_lengths = {{"my line", 1}, {"my_line", 2}};
    frame.muscles[0].path_lengths = {{"my line", 1}, {"my_line", 2}};
  }
  const StorageTable lengths = LengthTable(frames);
  EXPECT_THAT(
      lengths.labels,
      ElementsAre("my_line", "my_line_path", "my_line_", "my_line_path_"));
  EXPECT_THAT(lengths.times, ElementsAre(0, 1, 2));
}

TEST(MotionTables, AreWrittenSoThatTheyReadBack) {
  const std::string dir = TestTempDir();
  WriteMotionTables(Frames(), LegScene({"hip"}), dir);
  for (const char* name : {"lengths",
                           "volumes",
                           "moment_arms",
                           "fibre_lengths",
                           "fibre_moment_arms"}) {
    const StorageTable table = ReadStorageTable(dir + "/" + name + ".sto");
    EXPECT_EQ(table.times.size(), 3u) << name;
    EXPECT_EQ(table.in_degrees, false) << name;
    EXPECT_TRUE(table.warnings.empty()) << name;
  }
}

}  // namespace
}  // namespace musclewarp
