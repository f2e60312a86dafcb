// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/frame_files.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(AreaStretch, IsTheRatioOfAreas) {
  const TriangleSoup ball = Icosphere(10, 2);
  const Points twice = 2 * ball.points;
  const Eigen::VectorXd stretch =
      AreaStretch(ball.points, twice, ball.triangles);
  EXPECT_LT((stretch.array() - 4).abs().maxCoeff(), 1e-12);
  EXPECT_LT((AreaStretch(ball.points, ball.points, ball.triangles).array() - 1)
                .abs()
                .maxCoeff(),
            1e-15);
}

TEST(AreaStretch, IsOneWhereThereIsNoArea) {
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 5;
  const Triangles triangle = Eigen::RowVector3i(0, 1, 2);
  EXPECT_EQ(AreaStretch(points, 3 * points, triangle)[3], 1);
}

TEST(FrameFolder, HasFourDigits) {
  EXPECT_EQ(FrameFolder(7), "frame_0007");
  EXPECT_EQ(FrameFolder(12345), "frame_12345");
}

}  // namespace
}  // namespace musclewarp
