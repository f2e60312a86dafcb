// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/tunnelling.h"

#include <gtest/gtest.h>

#include <vector>

#include "certified_contact/contact_group.h"

namespace musclewarp {
namespace {

// A small muscle at height 20 over a bone of radius 5, and where it is carried.
class PassagesTest : public ::testing::Test {
 protected:
  double PassageTo(double height, double bone_height = 0) const {
    std::vector<Points> targets = group_.state.targets;
    targets[0].col(2).array() += height - 20;
    std::vector<Eigen::Matrix4d> bones = group_.state.bones_from_rest;
    bones[0](2, 3) += bone_height;
    return MaxTunnelling(
        MakeContactStep(group_.scene, group_.state, targets, bones));
  }

  ContactGroup group_{{SphereAt({0, 0, 20}, 1, 1)},
                      {SphereAt({0, 0, 0}, 5, 3)}};
};

TEST_F(PassagesTest, AreZeroWhereNothingIsInTheWay) {
  EXPECT_EQ(PassageTo(20), 0);
  EXPECT_EQ(PassageTo(8), 0);
  EXPECT_EQ(PassageTo(60), 0);
}

TEST_F(PassagesTest, BeginWhereAVertexRunsIntoTheBone) {
  // The lowest vertex is 1 below the centre, but the mesh of a sphere lies
  // inside of it.
  EXPECT_NEAR(PassageTo(4), 2, 0.1);
}

TEST_F(PassagesTest, GoOnBeyondTheBone) {
  EXPECT_NEAR(PassageTo(-20), 26, 0.1);
}

TEST_F(PassagesTest, AreThoseThatTheBoneSees) {
  EXPECT_NEAR(PassageTo(20, 40), PassageTo(-20), 1e-9);
  EXPECT_EQ(PassageTo(-20, -40), 0);
}

TEST_F(PassagesTest, OfTrianglesThatMayCrossTheBoneDoNotCount) {
  group_.scene.muscles[0].exempt = {
      std::vector<char>(group_.scene.muscles[0].triangles.rows(), 1)};
  EXPECT_EQ(PassageTo(-20), 0);
}

}  // namespace
}  // namespace musclewarp
