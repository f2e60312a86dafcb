// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/bare_tendon_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::IsEmpty;

// A straight line of 100 mm, of which the last 30 are a tendon.
ActionLine LineWithTendon() {
  ActionLine line;
  line.name = "line";
  line.rest = Points::Zero(11, 3);
  for (int i = 0; i < 11; ++i) line.rest(i, 2) = 10 * i;
  line.bodies.assign(11, "tibia");
  line.bare_end = 30;
  return line;
}

TEST(BareTendonLines, AreThePartsWithoutAMesh) {
  const auto tendons = BareTendonLines({LineWithTendon()}, nullptr);
  ASSERT_EQ(tendons.size(), 1u);
  EXPECT_EQ(tendons[0], LineWithTendon().rest.bottomRows(4));
}

TEST(BareTendonLines, MoveWithTheLine) {
  ScenePose pose;
  pose.bodies["tibia"] = Eigen::Matrix4d::Identity();
  pose.bodies["tibia"](0, 3) = 7;
  const auto tendons = BareTendonLines({LineWithTendon()}, &pose);
  ASSERT_EQ(tendons.size(), 1u);
  Points expected = LineWithTendon().rest.bottomRows(4);
  expected.col(0).array() += 7;
  EXPECT_EQ(tendons[0], expected);
}

TEST(BareTendonLines, AreNoneWhereTheMeshReachesTheBone) {
  ActionLine line = LineWithTendon();
  line.bare_end = 0;
  EXPECT_THAT(BareTendonLines({line}, nullptr), IsEmpty());
}

}  // namespace
}  // namespace musclewarp
