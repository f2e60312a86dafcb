// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/frame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Frame UsableFrame() {
  Frame frame;
  frame.name = "flexion_30";
  for (const char* name : {"psoas", "iliacus"}) {
    MuscleFrame muscle;
    muscle.name = name;
    muscle.volume_ratio = 1;
    muscle.solver.stop_reason = StopReason::kConverged;
    muscle.solver.iterations = 7;
    frame.muscles.push_back(muscle);
  }
  frame.muscles[1].volume_ratio = 0.97;
  frame.muscles[1].volume_error = -0.02;
  return frame;
}

TEST(Frame, IsUsableIfAllConvergedAndNothingIsMissing) {
  Frame frame = UsableFrame();
  EXPECT_TRUE(frame.IsUsable());
  frame.shortcomings = {"psoas x femur: 3 crossing triangle pairs"};
  EXPECT_FALSE(frame.IsUsable());
  frame = UsableFrame();
  frame.muscles[1].solver.stop_reason = StopReason::kFailed;
  EXPECT_FALSE(frame.IsUsable());
}

TEST(Frame, NamesTheMuscleThatDidNotConverge) {
  Frame frame = UsableFrame();
  EXPECT_EQ(frame.stop_reason(), ToString(StopReason::kConverged));
  frame.muscles[1].solver.stop_reason = StopReason::kIterationLimit;
  EXPECT_EQ(frame.stop_reason(),
            ToString(StopReason::kIterationLimit) + " (iliacus)");
}

TEST(Frame, SumsItsMusclesUp) {
  const Frame frame = UsableFrame();
  EXPECT_EQ(frame.iterations(), 14);
  EXPECT_DOUBLE_EQ(frame.WorstVolumeError(), 0.02);
}

TEST(Frame, ReportsSayWhatIsWrong) {
  Frame frame = UsableFrame();
  EXPECT_THAT(frame.BriefReport(), HasSubstr("flexion_30: usable"));
  EXPECT_THAT(frame.BriefReport(), Not(HasSubstr("\n")));
  frame.shortcomings = {"psoas x femur: 3 crossing triangle pairs"};
  EXPECT_THAT(frame.BriefReport(), HasSubstr("NOT usable"));
  EXPECT_THAT(frame.FullReport(), HasSubstr("iliacus"));
  EXPECT_THAT(frame.FullReport(),
              HasSubstr("psoas x femur: 3 crossing triangle pairs"));
}

}  // namespace
}  // namespace musclewarp
