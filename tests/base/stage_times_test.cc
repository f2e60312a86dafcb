// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/stage_times.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace musclewarp {
namespace {

void Wait(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

TEST(StageTimes, StagesAreListedAsTheyAreEnteredWithTheirVisits) {
  const StageRecording recording;
  {
    const ScopedStage outer("outer");
    for (int i = 0; i < 3; ++i) {
      const ScopedStage inner("inner");
    }
  }
  { const ScopedStage again("outer"); }
  ASSERT_EQ(recording.times().size(), 2);
  EXPECT_EQ(recording.times()[0].name, "outer");
  EXPECT_EQ(recording.times()[0].visits, 2);
  EXPECT_EQ(recording.times()[1].name, "inner");
  EXPECT_EQ(recording.times()[1].visits, 3);
}

// Sleeping takes at least as long as it is asked to.
TEST(StageTimes, TheTimeOfAnInnerStageCountsForItAlone) {
  const Stopwatch watch;
  const StageRecording recording;
  {
    const ScopedStage outer("outer");
    Wait(1);
    {
      const ScopedStage inner("inner");
      Wait(20);
    }
    Wait(1);
  }
  const double all = watch.Milliseconds();
  const double outer = recording.times()[0].ms, inner = recording.times()[1].ms;
  EXPECT_GE(inner, 20);
  EXPECT_GE(outer, 2);
  EXPECT_LE(outer + inner, all);
}

TEST(StageTimes, AnInnerRecordingTakesTheStagesFromTheOuterOne) {
  const StageRecording outer;
  {
    const StageRecording inner;
    { const ScopedStage stage("stage"); }
    EXPECT_EQ(inner.times().size(), 1);
  }
  EXPECT_TRUE(outer.times().empty());
  { const ScopedStage stage("another stage"); }
  EXPECT_EQ(outer.times().size(), 1);
}

TEST(StageTimes, OtherThreadsAreNotRecorded) {
  const StageRecording recording;
  std::thread([] { const ScopedStage stage("stage"); }).join();
  EXPECT_TRUE(recording.times().empty());
}

}  // namespace
}  // namespace musclewarp
