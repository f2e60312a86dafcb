// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/leaving_lines.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

// Two lines from the pelvis at z = 0 to the femur at z = 100, 20 mm apart.
std::vector<ActionLine> TwoLines() {
  std::vector<ActionLine> lines;
  for (const char* name : {"near", "far"}) {
    ActionLine line;
    line.name = name;
    line.bodies = {"pelvis", "femur"};
    line.rest.resize(2, 3);
    line.rest << 20.0 * lines.size(), 0, 0, 20.0 * lines.size(), 0, 100;
    lines.push_back(line);
  }
  return lines;
}

// An area of the pelvis or the femur around the end of the first line there.
Attachment AreaOn(const std::string& body) {
  Attachment area;
  area.body = body;
  area.points.resize(2, 3);
  area.points << -4, 0, 0, 2, 0, 0;
  if (body == "femur") area.points.col(2).array() += 100;
  return area;
}

// Poses that lift the femur, with targets of the lines that the scene gives.
std::vector<ScenePose> PosesWithTargets(double first_leaves_by) {
  std::vector<ScenePose> poses;
  for (const double lift : {5.0, 30.0}) {
    ScenePose pose;
    pose.name = "lift " + std::to_string(static_cast<int>(lift));
    Eigen::Matrix4d up = Eigen::Matrix4d::Identity();
    up(2, 3) = lift;
    pose.bodies["femur"] = up;
    for (const ActionLine& line : TwoLines()) {
      Points target = line.rest;
      target(1, 2) += lift;
      if (line.name == "near") target(0, 1) += first_leaves_by * lift / 30;
      pose.lines[line.name] = target;
    }
    poses.push_back(pose);
  }
  return poses;
}

TEST(FindLeavingLine, NamesTheLineThePoseAndTheDistance) {
  const auto leaving =
      FindLeavingLine(TwoLines(), AreaOn("pelvis"), PosesWithTargets(46));
  ASSERT_TRUE(leaving.has_value());
  EXPECT_EQ(leaving->line, "near");
  EXPECT_EQ(leaving->pose, "lift 30");
  EXPECT_NEAR(leaving->distance, 46, 1e-12);
}

TEST(FindLeavingLine, IsSilentWhereLinesStay) {
  // The other end of the same line, and a distance below 2 mm.
  EXPECT_FALSE(
      FindLeavingLine(TwoLines(), AreaOn("femur"), PosesWithTargets(46)));
  EXPECT_FALSE(
      FindLeavingLine(TwoLines(), AreaOn("pelvis"), PosesWithTargets(1.9)));
  EXPECT_FALSE(FindLeavingLine({}, AreaOn("pelvis"), PosesWithTargets(46)));
  EXPECT_FALSE(FindLeavingLine(TwoLines(), AreaOn("pelvis"), {}));
}

}  // namespace
}  // namespace musclewarp
