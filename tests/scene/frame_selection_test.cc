// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/frame_selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// Five poses at 0, 0.1, ..., 0.4 s.
std::vector<ScenePose> Motion() {
  std::vector<ScenePose> poses(5);
  for (size_t i = 0; i < poses.size(); ++i) poses[i].time = i / 10.0;
  return poses;
}

std::vector<int> Selected(const std::string& frames) {
  return SelectFrames(frames, Motion());
}

void ExpectFramesRefused(const std::string& frames, const std::string& why) {
  ExpectInputError([&] { Selected(frames); }, {"--frames=" + frames, why});
}

TEST(SelectFrames, KnowsAllAndLast) {
  EXPECT_THAT(Selected("all"), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(Selected("last"), ElementsAre(4));
}

TEST(SelectFrames, CountsBothEndsOfARange) {
  EXPECT_THAT(Selected("3"), ElementsAre(3));
  EXPECT_THAT(Selected("1:3"), ElementsAre(1, 2, 3));
  EXPECT_THAT(Selected("2:2"), ElementsAre(2));
  EXPECT_THAT(Selected("0:4:2"), ElementsAre(0, 2, 4));
  EXPECT_THAT(Selected("0:4:3"), ElementsAre(0, 3));
  EXPECT_THAT(Selected("1:2:9"), ElementsAre(1));
}

TEST(SelectFrames, TakesTimesFromTheFirstNotBeforeToTheLastNotAfter) {
  EXPECT_THAT(Selected("0.1s:0.3s"), ElementsAre(1, 2, 3));
  EXPECT_THAT(Selected("0.05s:0.35s"), ElementsAre(1, 2, 3));
  EXPECT_THAT(Selected("-1s:9s"), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(Selected("0.2s"), ElementsAre(2));
  EXPECT_THAT(Selected("1:0.3s"), ElementsAre(1, 2, 3));
}

TEST(SelectFrames, DividesPosesIntoParts) {
  EXPECT_THAT(Selected("1/1"), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(Selected("1/2"), ElementsAre(0, 1));
  EXPECT_THAT(Selected("2/2"), ElementsAre(2, 3, 4));
  for (int part = 0; part < 5; ++part) {
    EXPECT_THAT(Selected(std::to_string(part + 1) + "/5"), ElementsAre(part));
  }
  for (const char* frames : {"0/2", "3/2", "1/0"}) {
    ExpectFramesRefused(frames, "parts are numbered from 1");
  }
  ExpectFramesRefused("1/6", "has more parts than there are frames, 5");
  ExpectFramesRefused("1/", "not a frame number");
  ExpectFramesRefused("/2", "not a frame number");
}

TEST(SelectFrames, RefusesWhatIsNoSelection) {
  for (const char* frames : {"", ":", "1:", "1:2:3:4", "x", "-1", "1.5"}) {
    ExpectFramesRefused(frames, "not a frame number");
  }
  ExpectFramesRefused("999999999", "not a frame number");
  ExpectFramesRefused("xs", "not a time");
}

TEST(SelectFrames, SaysWhatTheSceneHasIfNothingIsSelected) {
  for (const char* frames : {"5", "3:2", "0:5", "0:4:0", "0.41s:0.5s"}) {
    ExpectFramesRefused(frames, "frames 0 to 4, 0s to 0.4s");
  }
}

// A run of the frames 7, 9 and 11, at 0.07, 0.09 and 0.11 s.
std::vector<int> SelectedOfRun(const std::string& frames) {
  const std::vector<int> numbers = {7, 9, 11};
  std::vector<ScenePose> poses(3);
  for (size_t i = 0; i < poses.size(); ++i) poses[i].time = numbers[i] / 100.0;
  return SelectFrames(frames, poses, numbers);
}

TEST(SelectFrames, NumbersAreThoseOfTheFramesOfARun) {
  EXPECT_THAT(SelectedOfRun("all"), ElementsAre(0, 1, 2));
  EXPECT_THAT(SelectedOfRun("last"), ElementsAre(2));
  EXPECT_THAT(SelectedOfRun("7"), ElementsAre(0));
  EXPECT_THAT(SelectedOfRun("8:11"), ElementsAre(1, 2));
  EXPECT_THAT(SelectedOfRun("7:11:4"), ElementsAre(0, 2));
  EXPECT_THAT(SelectedOfRun("0.08s:0.2s"), ElementsAre(1, 2));
  EXPECT_THAT(SelectedOfRun("0.08s:11:2"), ElementsAre(1, 2));
  for (const char* frames : {"0", "8", "0:11", "7:12", "0.2s:0.3s", "0s"}) {
    ExpectInputError(
        [&] { SelectedOfRun(frames); },
        {"--frames=", "frames 7 to 11 (3 of them), 0.07s to 0.11s"});
  }
}

}  // namespace
}  // namespace musclewarp
