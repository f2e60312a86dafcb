// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "report/records.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

TEST(Progress, IsALineAFrameOffATerminal) {
  std::ostringstream out;
  Progress progress(1, 3, false, &out);
  progress.FrameDone(SomeRecord(1));
  EXPECT_THAT(out.str(), HasSubstr("frame 2 of 3: t=0.1"));
  EXPECT_THAT(out.str(), HasSubstr("9 crossing pairs"));
  EXPECT_THAT(out.str(), HasSubstr("left\n"));
  EXPECT_EQ(out.str().find('\r'), std::string::npos);
}

TEST(Progress, RenewsOneLineOnATerminal) {
  std::ostringstream out;
  Progress progress(0, 2, true, &out);
  progress.FrameDone(SomeRecord(0));
  progress.FrameDone(SomeRecord(1));
  const std::string text = out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 2);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_THAT(text, HasSubstr("[============            ] 1 of 2"));
}

TEST(Progress, RoundsTimes) {
  EXPECT_EQ(RoundedTime(4400), "4 s");
  EXPECT_EQ(RoundedTime(99400), "99 s");
  EXPECT_EQ(RoundedTime(150000), "2 min");
  EXPECT_EQ(RoundedTime(7.3e6), "2 h");
}

}  // namespace
}  // namespace musclewarp
