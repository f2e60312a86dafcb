// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/resume_log.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "report/records.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

std::vector<MuscleState> SomeStates(int seed) {
  MuscleState with_offset;
  with_offset.coarse = Points::Constant(4, 3, 1.0 / (seed + 3));
  with_offset.contact.free_coarse = Points::Constant(4, 3, 1.0 / seed);
  with_offset.contact.fine_offset = Points::Constant(5, 3, 1e-17);
  MuscleState without;
  without.coarse = Points::Constant(2, 3, -seed);
  return {with_offset, without};
}

void ExpectStates(const std::vector<MuscleState>& states,
                  const std::vector<MuscleState>& expected) {
  ASSERT_EQ(states.size(), expected.size());
  for (size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(states[i].coarse, expected[i].coarse);
    ASSERT_EQ(states[i].contact.free_coarse.rows(),
              expected[i].contact.free_coarse.rows());
    EXPECT_EQ(states[i].contact.free_coarse, expected[i].contact.free_coarse);
    ASSERT_EQ(states[i].contact.fine_offset.rows(),
              expected[i].contact.fine_offset.rows());
    EXPECT_EQ(states[i].contact.fine_offset, expected[i].contact.fine_offset);
  }
}

TEST(ResumeLog, GivesBackWhatIsThereWithoutAGap) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  std::vector<MuscleState> states;
  EXPECT_TRUE(log.Continue({0, 5, 9}, &states).empty());
  log.FrameDone(SomeRecord(0), SomeStates(0));
  log.FrameDone(SomeRecord(5), SomeStates(5));
  const auto records = log.Continue({0, 5, 9}, &states);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(ToJson(records[1]), ToJson(SomeRecord(5)));
  ExpectStates(states, SomeStates(5));
  // Frame 4 is missing between: what comes after does not count.
  EXPECT_EQ(log.Continue({0, 4, 5}, &states).size(), 1u);
  ExpectStates(states, SomeStates(0));
}

TEST(ResumeLog, IsOfOneInput) {
  const std::string dir = TestTempDir();
  ResumeLog(dir, "hash").StartAnew();
  std::vector<MuscleState> states;
  EXPECT_THROW(ResumeLog(dir, "other").Continue({0}, &states), InputError);
}

TEST(ResumeLog, ForgetsWhenFinishedOrStartedAnew) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  log.FrameDone(SomeRecord(0), SomeStates(0));
  log.StartAnew();
  std::vector<MuscleState> states;
  EXPECT_TRUE(log.Continue({0}, &states).empty());
  log.Finish();
  EXPECT_TRUE(std::filesystem::is_empty(dir));
  EXPECT_TRUE(log.Continue({0}, &states).empty());
}

TEST(ResumeLog, RefusesADamagedFile) {
  const std::string dir = TestTempDir();
  const ResumeLog log(dir, "hash");
  log.StartAnew();
  log.FrameDone(SomeRecord(0), SomeStates(0));
  WriteTextAtomically(dir + "/.resume/frame_0000.cbor", "not cbor");
  std::vector<MuscleState> states;
  EXPECT_THROW(log.Continue({0}, &states), InputError);
}

}  // namespace
}  // namespace musclewarp
