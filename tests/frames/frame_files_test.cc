// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/frame_files.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/temp_dir.h"

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

TEST(FilesThatDiffer, AreThoseThatSomebodyChanged) {
  const std::string dir = TestTempDir();
  PreparedScene scene;
  const TriangleSoup ball = Icosphere(10.0 / 3, 1);
  scene.muscles.resize(1);
  scene.muscles[0].model.name = "muscle";
  scene.muscles[0].model.fine_triangles = ball.triangles;
  scene.bones.resize(1);
  scene.bones[0].mesh.name = "bone";
  scene.bones[0].rest = ball;
  Frame frame;
  frame.index = 0;
  frame.muscles.resize(1);
  frame.muscles[0].points = ball.points / 7;
  frame.bones = {ball.points};
  const std::vector<std::string> formats = {"ply", "obj"};
  WriteFrame(scene, frame, formats, dir);
  EXPECT_EQ(FilesThatDiffer(scene, frame, formats, dir),
            std::vector<std::string>());
  // By one bit of one coordinate.
  frame.muscles[0].points(5, 1) =
      std::nextafter(frame.muscles[0].points(5, 1), 9);
  EXPECT_EQ(FilesThatDiffer(scene, frame, {"ply"}, dir),
            std::vector<std::string>({"frame_0000/muscle.ply"}));
}

}  // namespace
}  // namespace musclewarp
