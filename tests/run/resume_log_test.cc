// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/resume_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "figures/some_figures.h"
#include "musclewarp/base/described_checks.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/input_file.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/run/frame_files.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

SceneState SomeState(int seed) {
  MuscleState with_offset;
  with_offset.coarse = Points::Constant(4, 3, 1.0 / (seed + 3));
  with_offset.corrections.fine_offset = Points::Constant(5, 3, 1e-17);
  MuscleState without;
  without.coarse = Points::Constant(2, 3, -seed);
  SceneState state;
  state.pose.name = "between";
  state.pose.time = 0.1 * seed;
  state.pose.coordinates = {{"hip_flexion", 1.0 / 3}};
  Eigen::Matrix4d target = Eigen::Matrix4d::Identity();
  target(1, 3) = 1.0 / (seed + 7);
  state.pose.bodies = {{"femur", target}};
  state.pose.lines = {{"psoas", Points::Constant(3, 3, 0.1)}};
  state.pose.model_values = {0.1, -0.2};
  state.pose.path_lengths = {{"psoas", 200.1}};
  state.muscles = {with_offset, without};
  state.contact.emplace().points = {Points::Constant(4, 3, 1.0 / (seed + 1))};
  return state;
}

void ExpectStates(const SceneState& state, const SceneState& expected) {
  ASSERT_EQ(state.muscles.size(), expected.muscles.size());
  for (size_t i = 0; i < state.muscles.size(); ++i) {
    const MuscleState &a = state.muscles[i], &b = expected.muscles[i];
    EXPECT_EQ(a.coarse, b.coarse);
    ASSERT_EQ(a.corrections.fine_offset.rows(),
              b.corrections.fine_offset.rows());
    EXPECT_EQ(a.corrections.fine_offset, b.corrections.fine_offset);
  }
  ASSERT_TRUE(state.contact.has_value());
  EXPECT_EQ(state.contact->points, expected.contact->points);
  EXPECT_EQ(state.pose.name, expected.pose.name);
  EXPECT_EQ(state.pose.time, expected.pose.time);
  EXPECT_EQ(state.pose.coordinates, expected.pose.coordinates);
  EXPECT_EQ(state.pose.bodies, expected.pose.bodies);
  EXPECT_EQ(state.pose.lines, expected.pose.lines);
  EXPECT_EQ(state.pose.model_values, expected.pose.model_values);
  EXPECT_EQ(state.pose.path_lengths, expected.pose.path_lengths);
}

// Writes a frame and its log.
void AddFrame(const ResumeLog& log, const std::string& dir, int index) {
  std::filesystem::create_directories(dir + "/" + FrameFolder(index));
  log.FrameDone(SomeFigures(index), SomeState(index));
}

TEST(ResumeLog, GivesBackWhatIsThereWithoutAGap) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  SceneState state;
  EXPECT_TRUE(log.Continue({0, 5, 9}, &state).empty());
  AddFrame(log, dir, 0);
  AddFrame(log, dir, 5);
  const auto records = log.Continue({0, 5, 9}, &state);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_TRUE(AreEqual(records[1], SomeFigures(5)));
  ExpectStates(state, SomeState(5));
  // Frame 4 is missing between: what comes after does not count.
  EXPECT_EQ(log.Continue({0, 4, 5}, &state).size(), 1u);
  ExpectStates(state, SomeState(0));
}

TEST(ResumeLog, IsOfOneInput) {
  const std::string dir = TestTempDir();
  ResumeLog(dir, "hash").StartAnew();
  SceneState state;
  EXPECT_THROW(ResumeLog(dir, "other").Continue({0}, &state), InputError);
}

TEST(ResumeLog, ForgetsWhenFinishedOrStartedAnew) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  AddFrame(log, dir, 0);
  log.StartAnew();
  SceneState state;
  EXPECT_TRUE(log.Continue({0}, &state).empty());
  log.Finish();
  EXPECT_FALSE(std::filesystem::exists(dir + "/.resume"));
  EXPECT_TRUE(log.Continue({0}, &state).empty());
}

TEST(ResumeLog, KeepsThePreparationWhenStartedAnew) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  const std::string file = log.PreparationFolder() + "/some.preparation";
  std::filesystem::create_directories(log.PreparationFolder());
  WriteTextAtomically(file, "prepared");
  log.StartAnew();
  EXPECT_TRUE(std::filesystem::exists(file));
  log.Finish();
  EXPECT_TRUE(std::filesystem::is_empty(dir));
}

// Frames count up to the first that is damaged.
TEST(ResumeLog, GoesOnBeforeADamagedFile) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  AddFrame(log, dir, 0);
  AddFrame(log, dir, 1);
  const std::string file = dir + "/.resume/frame_0001.cbor";
  const std::string whole = ReadFile(file);
  SceneState state;
  ASSERT_EQ(log.Continue({0, 1}, &state).size(), 2u);
  // Bits of the header, of the figures and of the state.
  for (size_t at = 0; at < whole.size(); at += 1 + whole.size() / 97) {
    std::string damaged = whole;
    damaged[at] ^= 1;
    WriteTextAtomically(file, damaged);
    EXPECT_EQ(log.Continue({0, 1}, &state).size(), 1u) << at;
    ExpectStates(state, SomeState(0));
  }
  for (const std::string& damaged : {std::string(), whole.substr(0, 40)}) {
    WriteTextAtomically(file, damaged);
    EXPECT_EQ(log.Continue({0, 1}, &state).size(), 1u);
  }
}

TEST(ResumeLog, TakesNoLogOfAnotherFrame) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  AddFrame(log, dir, 0);
  AddFrame(log, dir, 1);
  const std::string first = dir + "/.resume/frame_0000.cbor";
  const std::string second = dir + "/.resume/frame_0001.cbor";
  const std::string bytes = ReadFile(first);
  WriteTextAtomically(first, ReadFile(second));
  WriteTextAtomically(second, bytes);
  SceneState state;
  EXPECT_TRUE(log.Continue({0, 1}, &state).empty());
}

TEST(ResumeLog, GoesOnBeforeAFrameThatWasRemoved) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  for (const int index : {0, 1, 2}) AddFrame(log, dir, index);
  std::filesystem::create_directories(dir + "/rest");
  EXPECT_TRUE(log.Missing({0, 1, 2}).empty());
  std::filesystem::remove_all(dir + "/frame_0001");
  std::filesystem::remove_all(dir + "/rest");
  EXPECT_EQ(log.Missing({0, 1, 2}),
            std::vector<std::string>({"rest", "frame_0001"}));
  SceneState state;
  EXPECT_EQ(log.Continue({0, 1, 2}, &state).size(), 1u);
}

TEST(ResumeLog, RefusesLogsWithoutItsVersion) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  // As the key file was before it named a version.
  WriteTextAtomically(dir + "/.resume/inputs", "hash");
  SceneState state;
  ExpectInputError(
      [&] { log.Continue({0}, &state); },
      {".resume/inputs", "another version", "run without resume", "out"});
}

}  // namespace
}  // namespace musclewarp
