// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/drift_warnings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/records.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Three frames of a muscle whose second attachment leaves its body so far, mm.
std::vector<FrameRecord> Frames(double first, double second, double third) {
  std::vector<FrameRecord> frames;
  for (const double drift : {first, second, third}) {
    FrameRecord& frame =
        frames.emplace_back(SomeRecord(static_cast<int>(frames.size())));
    frame.name = "pose " + std::to_string(frames.size());
    frame.muscles[0].name = "psoas";
    frame.muscles[0].attachments = {
        {"pelvis", 3, 0.1, 0.2, {0, 0, 0}},
        {"femur", 4, drift / 10, drift, {1, 2, drift}}};
  }
  return frames;
}

TEST(DriftWarnings, NameTheWorstFrameOfAnAttachment) {
  EXPECT_THAT(
      DriftWarnings(Frames(2.5, 4, 3)),
      ElementsAre("psoas leaves femur, to which it is attached, by up to 4.0 "
                  "mm (0.4 on average) in pose 2 at (1.0, 2.0, 4.0)"));
}

TEST(DriftWarnings, AreGivenBeyondTwoMillimetresOnly) {
  EXPECT_THAT(DriftWarnings(Frames(0, 2, 1)), IsEmpty());
  EXPECT_THAT(DriftWarnings({}), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
