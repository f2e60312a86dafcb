// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/landmark_point.h"

#include <gtest/gtest.h>

#include "musclewarp/anatomy/bone_names.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// A tibia of 345 mm upright around the origin, whose radius is 12 mm, and the
// fibula beside it on the right; forward, up and right are the axes.
std::vector<MeasuredBone> Shank() {
  TriangleSoup tibia = Spindle(12, 172.5, 5), fibula = Spindle(6, 170, 5);
  for (TriangleSoup* bone : {&tibia, &fibula}) {
    const Points points = bone->points;
    bone->points.col(0) = points.col(1);
    bone->points.col(1) = points.col(2);
    bone->points.col(2) = points.col(0);
  }
  return {Measured(BoneOfName("tibia", tibia)),
          Measured(BoneOfName("fibula", MovedBy(fibula, {-18, -16, 29})))};
}

std::optional<LandmarkPoint> Find(const std::vector<BonePlace>& places) {
  return FindLandmark(
      places, Shank(), Side::kRight, Eigen::Matrix3d::Identity());
}

TEST(FindLandmark, IsOnTheSideAndAtThePartOfTheBone) {
  const auto place = Find({{"tibia", 0.2, 0.4, DirectionOfWords("anterior")}});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->bone, 0u);
  // Between 0.2 and 0.4 of the length from the top, on the front.
  EXPECT_LT(place->point.y(), 172.5 - 0.2 * 345);
  EXPECT_GT(place->point.y(), 172.5 - 0.4 * 345);
  EXPECT_GT(place->point.x(), 0.75 * 12);
  EXPECT_LT(std::abs(place->point.z()), 3);
  EXPECT_LT((place->outward - Eigen::RowVector3d(1, 0, 0)).norm(), 0.5);
}

TEST(FindLandmark, TakesTheFirstBoneThatIsThere) {
  const BonePlace talus = {"talus", 0, 1, DirectionOfWords("superior")};
  const BonePlace fibula = {"fibula", 0.9, 1, DirectionOfWords("lateral")};
  const auto place = Find({talus, fibula});
  ASSERT_TRUE(place);
  EXPECT_EQ(place->bone, 1u);
  EXPECT_NE(place->evidence, LandmarkEvidence::kFound);
  EXPECT_FALSE(Find({talus}));
}

TEST(FindLandmark, IgnoresBonesOfTheOtherSide) {
  std::vector<MeasuredBone> bones = Shank();
  for (MeasuredBone& bone : bones) bone.bone.side = Side::kLeft;
  EXPECT_FALSE(FindLandmark({{"tibia", 0, 1, DirectionOfWords("anterior")}},
                            bones,
                            Side::kRight,
                            Eigen::Matrix3d::Identity()));
}

}  // namespace
}  // namespace musclewarp
