// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/animation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/transformed.h"
#include "run/written_run.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

TEST(GltfFromAxes, PutsLeftUpAndFrontAlongXYZ) {
  const Points lps{{1, 2, 3}};  // 1 mm left, 2 mm back, 3 mm up
  EXPECT_EQ(GltfFromAxes("LPS").Convert(lps), Points({{1e-3, 3e-3, -2e-3}}));
  const Points asr{{1, 2, 3}};  // front, up, right
  EXPECT_EQ(GltfFromAxes("ASR").Convert(asr), Points({{-3e-3, 2e-3, 1e-3}}));
}

TEST(GltfFromAxes, KeepsTrianglesFacingOutward) {
  const TriangleSoup ball = Icosphere(10, 2);
  const double volume = SignedVolume(ball.points, ball.triangles);
  for (const char* axes : {"LPS", "RAS", "ASR", "LAS", "SPL"}) {
    const GltfConversion conversion = GltfFromAxes(axes);
    const double converted = SignedVolume(conversion.Convert(ball.points),
                                          conversion.Convert(ball.triangles));
    EXPECT_NEAR(converted * 1e9 / volume, 1, 1e-12) << axes;
  }
  EXPECT_TRUE(GltfFromAxes("LAS").turns_triangles);
  EXPECT_FALSE(GltfFromAxes("LPS").turns_triangles);
}

TEST(GltfFromAxes, MotionsAndPointsAreConvertedAlike) {
  const Eigen::Affine3d motion =
      Eigen::Translation3d(10, -20, 30) *
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const Points points = 100 * RandomPoints(20, 1);
  for (const char* axes : {"RAS", "LAS"}) {
    const GltfConversion conversion = GltfFromAxes(axes);
    const Points after =
        conversion.Convert(Transformed(points, motion.matrix()));
    const Points before = Transformed(conversion.Convert(points),
                                      conversion.Convert(motion.matrix()));
    // Metres, of 0.1 m.
    EXPECT_LT((after - before).cwiseAbs().maxCoeff(), 1e-15) << axes;
  }
}

TEST(AnimationOf, StartsAtZeroAndReadsFrames) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RunOutline run = ReadRunForExport(written.dir, "0");
  const Animation animation = AnimationOf(run, {0, 1});
  ASSERT_EQ(animation.times.size(), 2u);
  EXPECT_EQ(animation.times[0], 0);
  EXPECT_GT(animation.times[1], 0);
  EXPECT_EQ(animation.rest.bones[0].points, written.bone.points);
  const RecordedPose pose = animation.read(1);
  EXPECT_EQ(pose.muscles[0].points, written.muscle_frames[1]);
  EXPECT_EQ(pose.bones[0].points, written.bone_frames[1]);
  EXPECT_EQ(AnimationOf(run, {1}).times, std::vector<double>{0});
}

}  // namespace
}  // namespace musclewarp
