// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/pose_name.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace musclewarp {
namespace {

const std::vector<MovingCoordinate> kHip = {{"hip_flexion_r", "degrees"},
                                            {"pelvis_ty", "m"}};

TEST(PoseName, HasTheValuesOfWhatMoves) {
  EXPECT_EQ(
      PoseName("t=0.03", {{"hip_flexion_r", 5.001}, {"knee_angle_r", 9}}, kHip),
      "hip_flexion_r 5 degrees");
  EXPECT_EQ(
      PoseName(
          "t=0.03", {{"hip_flexion_r", -0.001}, {"pelvis_ty", 0.925}}, kHip),
      "hip_flexion_r 0 degrees, pelvis_ty 0.93 m");
  EXPECT_EQ(PoseName("t=0.03", {{"beta", 1.5}}, {{"beta", ""}}), "beta 1.5");
}

// Names of more coordinates would be longer than a line of the screen.
TEST(PoseName, IsThatOfTheMotionWhereManyMoveOrNone) {
  EXPECT_EQ(PoseName("t=0.03", {{"knee", 9}}, {}), "t=0.03");
  EXPECT_EQ(PoseName("bent", {}, kHip), "bent");
  std::map<std::string, double> values;
  std::vector<MovingCoordinate> moving;
  for (const char* name : {"a", "b", "c", "d"}) {
    values[name] = 1;
    moving.push_back({name, "m"});
    EXPECT_EQ(PoseName("t=1", values, moving) == "t=1", values.size() > 3);
  }
}

TEST(MovingCoordinatesIn, AreThoseThatTheReportSaysMove) {
  const auto in = [](const std::string& text) {
    return MovingCoordinatesIn(JsonField::Parse(text, "report.json"));
  };
  const auto moving = in(R"({"motion": {"coordinates": [
      {"name": "a", "unit": "degrees", "moves": true},
      {"name": "b", "unit": "m", "moves": false},
      {"name": "c", "unit": "", "moves": true}]}})");
  ASSERT_EQ(moving.size(), 2u);
  EXPECT_EQ(moving[0].name + moving[0].unit, "adegrees");
  EXPECT_EQ(moving[1].name + moving[1].unit, "c");
  EXPECT_TRUE(in(R"({"motion": null})").empty());
  EXPECT_TRUE(in("{}").empty());
}

}  // namespace
}  // namespace musclewarp
