// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/frame_measures.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/motion/solved_pose.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

std::vector<SolverSummary> TwoSummaries() {
  std::vector<SolverSummary> summaries(2);
  summaries[1].iterations = 5;
  return summaries;
}

TEST(MeasureFrame, OfMusclesAtRestIsTheRestFrame) {
  const PreparedScene scene = PreparedSmallScene();
  SceneMeshes meshes(scene);
  const Frame rest = RestFrame(scene, &meshes);
  const SceneState state = RestState(scene);
  const Frame frame = MeasureFrame(scene,
                                   state.pose,
                                   ShapesOf(scene, state.muscles),
                                   {},
                                   TwoSummaries(),
                                   &meshes);
  for (size_t i = 0; i < 2; ++i) {
    // W X_0 is the fine rest mesh to 1e-12 mm.
    EXPECT_LT((frame.muscles[i].points - rest.muscles[i].points)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-11);
    EXPECT_NEAR(frame.muscles[i].volume_ratio, 1, 1e-12);
    EXPECT_NEAR(rest.muscles[i].volume / frame.muscles[i].volume, 1, 1e-12);
    for (const auto& [line, length] : frame.muscles[i].line_lengths) {
      EXPECT_NEAR(rest.muscles[i].line_lengths.at(line), length, 1e-11);
    }
    EXPECT_EQ(frame.muscles[i].folded_triangles, 0);
    EXPECT_EQ(frame.bones[i], rest.bones[i]);
    // 1 mm to the other muscle.
    EXPECT_NEAR(frame.muscles[i].gaps.minCoeff(), 1, 0.2);
  }
  EXPECT_EQ(frame.muscles[1].solver.iterations, 5);
  EXPECT_TRUE(frame.intersections.IsClean());
}

TEST(MeasureFrame, CountsWhatCrossesAndMovesTheBones) {
  const PreparedScene scene = PreparedSmallScene();
  SceneMeshes meshes(scene);
  ScenePose pose;
  pose.name = "down";
  Eigen::Matrix4d down = Eigen::Matrix4d::Identity();
  down(2, 3) = -15;  // 10 mm into the muscles
  pose.bodies["femur"] = down;
  const Frame frame = MeasureFrame(scene,
                                   pose,
                                   ShapesOf(scene, RestState(scene).muscles),
                                   {},
                                   TwoSummaries(),
                                   &meshes);
  EXPECT_EQ(frame.name, "down");
  EXPECT_EQ(frame.bones[1], Transformed(scene.bones[1].rest.points, down));
  EXPECT_GT(frame.intersections.triangle_pairs, 0);
  ASSERT_EQ(frame.intersections.pairs.size(), 2u);
  EXPECT_EQ(frame.intersections.pairs[0].b, "femur");
  EXPECT_LT(frame.muscles[0].gaps.minCoeff(), 0);
  // The smallest gap is the same if the others are not wanted.
  const Frame without = MeasureFrame(scene,
                                     pose,
                                     ShapesOf(scene, RestState(scene).muscles),
                                     {},
                                     TwoSummaries(),
                                     &meshes,
                                     {/*vertex_gaps=*/false});
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(without.muscles[i].gaps.size(), 0);
    EXPECT_EQ(without.muscles[i].min_gap, frame.muscles[i].gaps.minCoeff());
    EXPECT_EQ(frame.muscles[i].min_gap, frame.muscles[i].gaps.minCoeff());
  }
}

TEST(IntersectAtRest, SeesWhereTheMusclesAre) {
  const PreparedScene scene = PreparedSmallScene();
  const SceneState rest = RestState(scene);
  SceneMeshes meshes(scene);
  std::vector<Points> muscles = FinePointsOf(scene, &rest);
  EXPECT_TRUE(IntersectAtRest(scene, muscles, &meshes).IsClean());
  muscles[0].col(0).array() += 4;  // into the other
  EXPECT_FALSE(IntersectAtRest(scene, muscles, &meshes).IsClean());
}

}  // namespace
}  // namespace musclewarp
