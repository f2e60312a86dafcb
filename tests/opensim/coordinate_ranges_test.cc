// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/coordinate_ranges.h"
#include "musclewarp/base/angles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// An elbow that is bent by -172 to 172 degrees, and a slide of -5 to 5 m.
Model Arm() {
  Model model;
  model.coordinates.resize(2);
  model.coordinates[0].name = "elbow_flex";
  model.coordinates[0].range = {-3, 3};
  model.coordinates[1].name = "tx";
  model.coordinates[1].kind = CoordinateKind::kTranslational;
  model.coordinates[1].range = {-5, 5};
  return model;
}

std::vector<std::string> WarningsAt(const Model& model,
                                    const CoordinateValues& values,
                                    bool in_degrees) {
  return RangeWarnings(
      model, {0, 1}, {{0, 0}, values, {0, 0}}, "m.mot", in_degrees);
}

TEST(CoordinateRanges, AsksWhetherAMotionIsInDegrees) {
  EXPECT_THAT(
      WarningsAt(Arm(), {60, 0}, false),
      ElementsAre(HasSubstr("m.mot: elbow_flex goes to 60 rad = 3438 degrees, "
                            "the model has -172 to 172: is the motion in "
                            "degrees?")));
  EXPECT_THAT(WarningsAt(Arm(), {-60, 0}, true),
              ElementsAre(HasSubstr("goes to -3438 degrees")));
  EXPECT_THAT(WarningsAt(Arm(), {0, 950}, true),
              ElementsAre(HasSubstr("tx goes to 950 m, the model has -5 to 5: "
                                    "is the motion in mm?")));
}

TEST(CoordinateRanges, ALittleBeyondIsWorthAWordOnlyIfTheModelClamps) {
  Model arm = Arm();
  EXPECT_THAT(WarningsAt(arm, {RadiansOf(190), 6}, true), IsEmpty());
  arm.coordinates[0].is_clamped = true;
  EXPECT_THAT(WarningsAt(arm, {RadiansOf(190), 6}, true),
              ElementsAre(HasSubstr("goes to 190 degrees, the model has -172 "
                                    "to 172 and clamps it there")));
  EXPECT_THAT(WarningsAt(arm, {3, 6}, true), IsEmpty());
}

TEST(CoordinateRanges, AModelThatSaysNoneHasNone) {
  Model arm = Arm();
  arm.coordinates[0].range.reset();
  EXPECT_THAT(WarningsAt(arm, {1000, 0}, false), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
