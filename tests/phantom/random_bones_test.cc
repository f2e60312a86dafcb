// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/random_bones.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "musclewarp/phantom/scene_parts.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp::phantom {
namespace {

using Eigen::Vector3d;

class RandomBones : public ::testing::TestWithParam<int> {
 protected:
  RandomBones() {
    RandomDraws draws(GetParam());
    bones_ = DrawBones(&draws);
  }
  std::vector<RandomBone> bones_;
};

TEST_P(RandomBones, AreATreeWhoseParentsComeFirst) {
  EXPECT_GE(bones_.size(), 2u);
  EXPECT_LE(bones_.size(), 6u);
  EXPECT_EQ(bones_[0].parent, -1);
  std::set<std::string> names;
  for (size_t i = 0; i < bones_.size(); ++i) {
    EXPECT_LT(bones_[i].parent, static_cast<int>(i));
    EXPECT_EQ(bones_[i].parent < 0, i == 0);
    EXPECT_TRUE(names.insert(bones_[i].name).second) << bones_[i].name;
  }
}

TEST_P(RandomBones, HaveSoundMeshesOfTheSizesOfBones) {
  for (const RandomBone& bone : bones_) {
    EXPECT_TRUE(IsSoundSurface(bone.mesh.surface)) << bone.name;
    const Eigen::RowVector3d sizes =
        bone.mesh.surface.points.colwise().maxCoeff() -
        bone.mesh.surface.points.colwise().minCoeff();
    // The longest side of an upright box is at least 1 / sqrt(3) of a length,
    // and its diagonal is longer than that by a socket at most.
    EXPECT_GT(sizes.maxCoeff(), 80 / std::sqrt(3.)) << bone.name;
    EXPECT_LT(sizes.maxCoeff(), 400) << bone.name;
  }
}

TEST_P(RandomBones, AreApartAndMeetInTheirJoints) {
  constexpr double kJointReach = 40;  // mm, more than the radius of any head
  for (size_t i = 0; i < bones_.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(
          IntersectMeshes(bones_[i].mesh.surface, bones_[j].mesh.surface)
              .IsEmpty())
          << bones_[i].name << " x " << bones_[j].name;
    }
    if (i == 0) continue;
    EXPECT_LT(bones_[i].field(bones_[i].joint), kJointReach);
    if (bones_[i].is_beside_parent) continue;
    EXPECT_LT(bones_[bones_[i].parent].field(bones_[i].joint), kJointReach);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBones, ::testing::Range(1, 4));

TEST(LeastBoneDistance, IsThatOfTheNearestTwoInThePose) {
  std::vector<RandomBone> bones(2);
  for (int i = 0; i < 2; ++i) {
    const Vector3d centre(100 * i, 0, 0);
    bones[i].field = Sphere(centre, 20);
    bones[i].mesh = MeshOf(
        {"ball",
         bones[i].field,
         {centre - Vector3d::Constant(25), centre + Vector3d::Constant(25)},
         4,
         {},
         /*roughness=*/0},
        1);
  }
  std::vector<Eigen::Matrix4d> pose(2, Eigen::Matrix4d::Identity());
  // No vertex need be at the nearest point: 0.1 mm for cells of 4 mm.
  constexpr double kFacets = 0.3;  // mm
  EXPECT_NEAR(LeastBoneDistance(bones, pose), 60, kFacets);
  pose[1](0, 3) = -55;
  EXPECT_NEAR(LeastBoneDistance(bones, pose), 5, kFacets);
  pose[1](0, 3) = -63;
  EXPECT_NEAR(LeastBoneDistance(bones, pose), -3, kFacets);
}

}  // namespace
}  // namespace musclewarp::phantom
