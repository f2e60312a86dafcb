// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/screen_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <string>
#include <thread>

#include "figures/some_figures.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(ScreenProgress, IsALineForEachFrameOffATerminal) {
  std::ostringstream out;
  ScreenProgress progress(false, &out);
  progress.StartFrames(1, {1, 1});
  progress.FrameDone(SomeFigures(1), "bent");
  EXPECT_THAT(out.str(), HasSubstr("frame 2 of 3: bent"));
  EXPECT_THAT(out.str(), HasSubstr("9 crossing pairs"));
  EXPECT_THAT(out.str(), HasSubstr("left\n"));
  EXPECT_EQ(out.str().find('\r'), std::string::npos);
}

TEST(ScreenProgress, RenewsOneLineOnATerminal) {
  std::ostringstream out;
  ScreenProgress progress(true, &out);
  progress.StartFrames(0, {1, 1});
  progress.FrameDone(SomeFigures(0), "bent");
  progress.FrameDone(SomeFigures(1), "bent");
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 2);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_THAT(text, HasSubstr("[============            ] 1 of 2"));
}

// A log gets one line at once, and then one a minute.
TEST(ScreenProgress, SaysWhatIsDoneAndHowFarItIs) {
  std::ostringstream out;
  ScreenProgress progress(false, &out);
  progress.Say({"preparing", 2, 7, "mesh of soleus_r"});
  progress.Say({"preparing", 3, 7, "mesh of tibia_r"});
  EXPECT_EQ(out.str(), "preparing 2 of 7: mesh of soleus_r ... (0 s)\n");
}

TEST(ScreenProgress, CountsTheSecondsOnATerminal) {
  std::ostringstream out;
  ScreenProgress progress(true, &out);
  progress.Say({"separating", 3, 0, "12 pairs of triangles cross"});
  // The line is renewed once a second, after up to another second.
  std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  progress.Clear();
  EXPECT_THAT(
      out.str(),
      AllOf(HasSubstr(
                "\rseparating, round 3: 12 pairs of triangles cross ... (0 s)"),
            HasSubstr(" ... (2 s)")));
}

// A line that wraps could not be renewed.
TEST(ScreenProgress, CutsItsLineOnATerminal) {
  std::ostringstream out;
  ScreenProgress progress(true, &out);
  progress.Say({"preparing", 2, 7, std::string(3000, 'm')});
  EXPECT_LT(out.str().size(), 1000u);
}

TEST(ScreenProgress, SaysThatAFrameIsNotUsable) {
  std::ostringstream out;
  ScreenProgress progress(false, &out);
  progress.StartFrames(0, {1});
  FrameFigures record = SomeFigures(0);
  record.shortcomings = {"crosses a bone"};
  progress.FrameDone(record, "bent");
  EXPECT_THAT(out.str(), HasSubstr("NOT usable"));
}

// The time that is left goes by the work of the frames that are left.
TEST(ScreenProgress, ForetellsTheTimeByTheWork) {
  std::ostringstream out;
  ScreenProgress one(false, &out), ten(false, &out);
  one.StartFrames(0, {1, 1});
  ten.StartFrames(0, {1, 10});
  EXPECT_EQ(one.MillisecondsLeft(), 0);  // nothing is known yet
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  one.FrameDone(SomeFigures(0), "bent");
  ten.FrameDone(SomeFigures(0), "bent");
  EXPECT_GT(one.MillisecondsLeft(), 0);
  // The two clocks were read at nearly the same time.
  EXPECT_GT(ten.MillisecondsLeft(), 5 * one.MillisecondsLeft());
}

TEST(ScreenProgress, ClearsItsLineOfATerminal) {
  std::ostringstream out;
  ScreenProgress progress(true, &out);
  progress.StartFrames(0, {1, 1});
  progress.FrameDone(SomeFigures(0), "bent");
  progress.Clear();
  const std::string text = out.str();
  EXPECT_EQ(text.back(), '\r');
  const size_t length = text.size();
  progress.Clear();
  EXPECT_EQ(out.str().size(), length);
}

TEST(RoundedTime, IsAsPreciseAsPeopleWant) {
  EXPECT_EQ(RoundedTime(4400), "4 s");
  EXPECT_EQ(RoundedTime(99400), "99 s");
  EXPECT_EQ(RoundedTime(150000), "2 min");
  EXPECT_EQ(RoundedTime(7.3e6), "2 h");
}

}  // namespace
}  // namespace musclewarp
