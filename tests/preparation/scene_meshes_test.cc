// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scene_meshes.h"

#include <gtest/gtest.h>

#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

TEST(SceneMeshes, AreAtRestAtFirstAndFollowThePoints) {
  const PreparedScene scene = PreparedSmallScene();
  SceneMeshes meshes(scene);
  ASSERT_EQ(meshes.muscles().size(), 2u);
  ASSERT_EQ(meshes.bones().size(), 2u);
  EXPECT_EQ(meshes.muscles()[0].name, "left");
  EXPECT_EQ(meshes.bones()[1].name, "femur");
  std::vector<Points> muscles, bones;
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(meshes.muscles()[i].mesh->points(),
              scene.muscles[i].model.fine_rest);
    muscles.push_back(2 * meshes.muscles()[i].mesh->points());
    bones.push_back(meshes.bones()[i].mesh->points());
  }
  meshes.MoveTo(muscles, bones);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(meshes.muscles()[i].mesh->points(), muscles[i]);
    EXPECT_EQ(meshes.bones()[i].mesh->points(), bones[i]);
  }
  // The trees have moved along: a vertex is on its surface.
  const Eigen::RowVector3d p = muscles[1].row(7);
  EXPECT_EQ(meshes.muscles()[1].mesh->bvh().ClosestPoint(p).distance, 0);
}

}  // namespace
}  // namespace musclewarp
