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

TEST(ResumeLog, GivesBackWhatIsThereWithoutAGap) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  SceneState state;
  EXPECT_TRUE(log.Continue({0, 5, 9}, &state).empty());
  log.FrameDone(SomeFigures(0), SomeState(0));
  log.FrameDone(SomeFigures(5), SomeState(5));
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
  log.FrameDone(SomeFigures(0), SomeState(0));
  log.StartAnew();
  SceneState state;
  EXPECT_TRUE(log.Continue({0}, &state).empty());
  log.Finish();
  EXPECT_TRUE(std::filesystem::is_empty(dir));
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

TEST(ResumeLog, RefusesADamagedFile) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  log.FrameDone(SomeFigures(0), SomeState(0));
  WriteTextAtomically(dir + "/.resume/frame_0000.cbor", "not cbor");
  SceneState state;
  ExpectInputError([&] { log.Continue({0}, &state); },
                   {"frame_0000.cbor", "damaged", "without resume"});
}

// Expects that a log is refused once `change` has been done to the JSON of its
// only frame.
void ExpectRefused(const std::function<void(nlohmann::json*)>& change) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  log.FrameDone(SomeFigures(0), SomeState(0));
  const std::string file = dir + "/.resume/frame_0000.cbor";
  auto json = nlohmann::json::from_cbor(ReadFile(file));
  change(&json);
  const auto bytes = nlohmann::json::to_cbor(json);
  WriteTextAtomically(file, std::string(bytes.begin(), bytes.end()));
  SceneState state;
  ExpectInputError(
      [&] { log.Continue({0}, &state); },
      {"frame_0000.cbor", "this build", "run without resume", "out"});
}

TEST(ResumeLog, RefusesFramesOfAnotherLayout) {
  using nlohmann::json;
  ExpectRefused([](json* frame) { frame->erase("state"); });
  ExpectRefused([](json* frame) { frame->erase("record"); });
  ExpectRefused([](json* frame) { (*frame)["record"].erase("index"); });
  ExpectRefused([](json* frame) { (*frame)["state"] = 5; });
  // Too short, and with a number of muscles that no memory holds.
  ExpectRefused([](json* frame) { (*frame)["state"] = json::binary({1}); });
  ExpectRefused([](json* frame) {
    auto& bytes = (*frame)["state"].get_binary();
    std::fill(bytes.begin(), bytes.end(), 0x7f);
  });
  ExpectRefused([](json* frame) { *frame = json::array(); });
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
