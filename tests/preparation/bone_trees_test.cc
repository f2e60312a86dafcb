// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bone_trees.h"

#include <gtest/gtest.h>

#include "musclewarp/preparation/prepared_scene.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

TEST(BoneTrees, AreSharedWhileTheBoneIsTheSame) {
  std::vector<PreparedBone> bones(2);
  bones[0].rest = Box(10, 20, 30);
  bones[1].rest = Icosphere(20, 2);
  AddBoneTrees(&bones);
  for (const PreparedBone& bone : bones) {
    EXPECT_EQ(TreesOf(bone), bone.trees);
    EXPECT_EQ(bone.trees->mesh.points(), bone.rest.points);
    EXPECT_EQ(bone.trees->clusters.num_triangles(), bone.rest.triangles.rows());
    const PreparedBone copy = bone;
    EXPECT_EQ(TreesOf(copy), bone.trees);
  }
}

// Whatever changes a bone need not think of its trees.
TEST(BoneTrees, AreNewOnesOfAChangedBone) {
  std::vector<PreparedBone> bones(1);
  bones[0].rest = Box(10, 20, 30);
  AddBoneTrees(&bones);
  PreparedBone larger = bones[0], open = bones[0];
  larger.rest.points *= 2;
  open.rest.triangles.conservativeResize(11, 3);
  for (const PreparedBone& bone : {larger, open}) {
    EXPECT_NE(TreesOf(bone), bone.trees);
    EXPECT_EQ(TreesOf(bone)->mesh.points(), bone.rest.points);
    EXPECT_EQ(TreesOf(bone)->mesh.triangles(), bone.rest.triangles);
  }
}

// A copy of a mesh moves alone, and finds the same.
TEST(SearchableMesh, CopiesHaveTreesOfTheirOwn) {
  const SearchableMesh ball(Icosphere(10, 2));
  SearchableMesh moved = ball;
  const Eigen::RowVector3d away(100, 0, 0);
  const Points points = ball.points().rowwise() + away;
  moved.Refit(points);
  const Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
  EXPECT_TRUE(ball.winding().IsInside(centre));
  EXPECT_FALSE(moved.winding().IsInside(centre));
  EXPECT_TRUE(moved.winding().IsInside(away));
  EXPECT_NEAR(moved.bvh().ClosestPoint(away).distance,
              ball.bvh().ClosestPoint(centre).distance,
              1e-12);
}

}  // namespace
}  // namespace musclewarp
