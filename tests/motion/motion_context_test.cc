// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/motion_context.h"

#include <gtest/gtest.h>

#include "musclewarp/scene/line_targets.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

class MoverTest : public ::testing::Test {
 protected:
  MoverTest()
      : scene_(PreparedSmallScene()),
        certified_(PrepareCertifiedScene(scene_,
                                         SceneMeshes(scene_),
                                         {},
                                         {},
                                         ReferenceSolvers().single,
                                         {})) {}

  const PreparedScene scene_;
  const CertifiedScene certified_;
};

TEST_F(MoverTest, AStateWithoutContactHasVerticesWhereCoarseMeshesHaveThem) {
  std::vector<Points> coarse = certified_.rest.coarse;
  coarse[0](3, 1) += 2;
  const ContactState state =
      StateWithoutContact(scene_, certified_, FlexedPose(0.1), coarse);
  EXPECT_EQ(state.pose.name, "flexed");
  EXPECT_EQ(state.coarse, coarse);
  EXPECT_EQ(state.free_coarse, coarse);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(state.points[i],
              FinePoints(certified_.muscles[i]->model, {coarse[i], {}}));
    EXPECT_EQ(state.targets[i], state.points[i]);
  }
  EXPECT_TRUE(state.planes.empty());
}

TEST_F(MoverTest, BonesAreWhereThePoseHasThem) {
  const ScenePose pose = FlexedPose(0.1);
  const std::vector<Eigen::Matrix4d> bones = BonesFromRest(scene_, pose);
  ASSERT_EQ(bones.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(bones[i], BodyTransform(pose, scene_.bones[i].body));
  }
}

// In the rest pose attached vertices are where they are.
TEST_F(MoverTest, AttachedVerticesFollowTheirBodiesFromTheRestPose) {
  const ScenePose rest = certified_.rest.pose;
  const std::vector<AttachedPoints> held = AttachedIn(certified_, rest);
  ASSERT_EQ(held.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const Points& points = certified_.rest.points[i];
    // Weights of the attachments of a vertex add up to one but for rounding.
    EXPECT_LT((held[i].positions - Points(points(held[i].vertices, Eigen::all)))
                  .norm(),
              1e-10);
  }
}

}  // namespace
}  // namespace musclewarp
