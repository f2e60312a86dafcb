// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bones_at_rest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/base/angles.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A hip: a ball of 24 mm, far from the origin, in a block.
struct Hip {
  Eigen::Vector3d centre{90, 60, 900};
  std::string pelvis_name = "hip_bone", femur_name = "femur";
  TriangleSoup pelvis = MovedBy(Box(80, 80, 60), {90, 60, 956});
  TriangleSoup femur = MovedBy(Icosphere(24, 3), {90, 60, 900});
  Scene scene;

  // Adds a pose in which the femur has turned about a point.
  void AddFlexion(double degrees, const Eigen::Vector3d& about) {
    ScenePose pose;
    pose.name = "flexion_" + std::to_string(static_cast<int>(degrees));
    const Eigen::Affine3d turn =
        Eigen::Translation3d(about) *
        Eigen::AngleAxisd(RadiansOf(degrees), Eigen::Vector3d::UnitX()) *
        Eigen::Translation3d(-about);
    pose.bodies["femur"] = turn.matrix();
    scene.poses.push_back(pose);
  }
  std::vector<std::string> Warnings() const {
    return BoneMoveWarnings(scene,
                            {{pelvis_name, pelvis_name, SearchableMesh(pelvis)},
                             {femur_name, femur_name, SearchableMesh(femur)}});
  }
};

TEST(BoneMoves, OfAJointAreNotNamed) {
  Hip hip;
  hip.AddFlexion(60, hip.centre);
  hip.AddFlexion(120, hip.centre);
  EXPECT_THAT(hip.Warnings(), IsEmpty());
}

TEST(BoneMoves, AboutTheOriginOfAnImageAreNamed) {
  Hip hip;
  hip.scene.is_motion = true;
  hip.AddFlexion(1, Eigen::Vector3d::Zero());
  hip.AddFlexion(15, Eigen::Vector3d::Zero());
  EXPECT_THAT(hip.Warnings(),
              ElementsAre(AllOf(HasSubstr("femur moves by 2"),
                                HasSubstr("against hip_bone between frames 0 "
                                          "and 1 (flexion_15)"),
                                HasSubstr("centre of the joint"))));
}

TEST(BoneCrossings, AreThoseOfBonesAsDelivered) {
  const std::string a = "sacrum", b = "hip_bone", c = "femur";
  const TriangleSoup box = Box(10, 10, 10);
  const SearchableMesh one(box), two(MovedBy(box, {8, 1, 1})),
      apart(MovedBy(box, {40, 0, 0}));
  const auto crossings =
      BoneCrossings({{a, a, one}, {b, b, two}, {c, c, apart}});
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(crossings[0].a, "sacrum");
  EXPECT_EQ(crossings[0].b, "hip_bone");
  EXPECT_GT(crossings[0].triangle_pairs, 0);
}

}  // namespace
}  // namespace musclewarp
