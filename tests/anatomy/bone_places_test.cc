// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/bone_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/anatomy/bone_place_rows.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> BonesOf(const std::string& landmark) {
  std::vector<std::string> bones;
  for (const BonePlace& place : PlacesOfLandmark(landmark)) {
    bones.push_back(place.bone);
  }
  return bones;
}

BonePlace PlaceOn(const std::string& bone, const std::string& landmark) {
  for (const BonePlace& place : PlacesOfLandmark(landmark)) {
    if (place.bone == bone) return place;
  }
  ADD_FAILURE() << landmark << " is not on " << bone;
  return {};
}

TEST(PlacesOfLandmark, AreOnBonesThatHaveNames) {
  for (const std::string& landmark : LandmarkNames()) {
    for (const std::string& bone : BonesOf(landmark)) {
      const NamedBone named = ParseBoneName(bone);
      EXPECT_TRUE(named.is_known) << landmark << ": " << bone;
      EXPECT_FALSE(named.side) << landmark << ": " << bone;
    }
  }
}

TEST(PlacesOfLandmark, NameEachBoneOnce) {
  for (const std::string& landmark : LandmarkNames()) {
    const std::vector<std::string> bones = BonesOf(landmark);
    const std::set<std::string> different(bones.begin(), bones.end());
    EXPECT_EQ(different.size(), bones.size()) << landmark;
  }
}

TEST(PlacesOfLandmark, LieWithinTheBoneOnOneSideOfIt) {
  const double rounding = 1e-12;
  for (const std::string& landmark : LandmarkNames()) {
    for (const BonePlace& place : PlacesOfLandmark(landmark)) {
      EXPECT_GE(place.begin, 0) << landmark << " on " << place.bone;
      EXPECT_LT(place.begin, place.end) << landmark << " on " << place.bone;
      EXPECT_LE(place.end, 1) << landmark << " on " << place.bone;
      EXPECT_NEAR(place.direction.norm(), 1, rounding) << landmark;
    }
  }
}

TEST(PlacesOfLandmark, BeginWithTheBoneThatHasItAndEndWithTheWholeFoot) {
  EXPECT_THAT(BonesOf("first_ray_medial"),
              ElementsAre("metatarsal_1",
                          "cuneiform_medial",
                          "metatarsals",
                          "foot",
                          "tarsals"));
  EXPECT_THAT(BonesOf("asis"), ElementsAre("hip_bone", "pelvis"));
  EXPECT_THAT(BonesOf("head_of_fibula"), ElementsAre("fibula", "tibia"));
}

// The base of a metatarsal lies within the foot where that bone begins.
TEST(PlacesOfLandmark, AreTheSamePlaceInAMeshOfSeveralBones) {
  for (const WholeRow& row : WholeRowsOfLeg()) {
    EXPECT_LT(row.begin, row.end) << row.part << " in " << row.whole;
    for (const std::string& landmark : LandmarkNames()) {
      if (BonesOf(landmark).front() != row.part) continue;
      const BonePlace place = PlaceOn(row.whole, landmark);
      EXPECT_GE(place.begin, row.begin) << landmark << " in " << row.whole;
      EXPECT_LE(place.end, row.end) << landmark << " in " << row.whole;
    }
  }
  const BonePlace base = PlaceOn("foot", "first_ray_medial");
  EXPECT_NEAR(base.begin, 0.49, 1e-12);
  EXPECT_LT(base.direction.z(), 0);
  EXPECT_LT(base.direction.y(), 0);
}

TEST(PlacesOfLandmark, KnowMedialFromLateralAndFrontFromBack) {
  EXPECT_LT(PlaceOn("tibia", "pes_anserinus").direction.z(), 0);
  EXPECT_GT(PlaceOn("fibula", "head_of_fibula").direction.z(), 0);
  EXPECT_LT(PlaceOn("calcaneus", "calcaneal_tuberosity").direction.x(), 0);
  EXPECT_GT(PlaceOn("patella", "base_of_patella").direction.x(), 0);
  EXPECT_LT(PlaceOn("humerus", "medial_epicondyle").direction.z(), 0);
  EXPECT_GT(PlaceOn("metatarsal_5", "tuberosity_of_metatarsal_5").direction.z(),
            0);
}

TEST(DirectionOfWords, IsTheMeanOfItsWords) {
  EXPECT_EQ(DirectionOfWords("plantar"), Eigen::Vector3d(0, -1, 0));
  EXPECT_TRUE(DirectionOfWords("anterior medial")
                  .isApprox(Eigen::Vector3d(1, 0, -1).normalized()));
  EXPECT_TRUE(DirectionOfWords("medial medial anterior")
                  .isApprox(Eigen::Vector3d(1, 0, -2).normalized()));
  EXPECT_EQ(DirectionOfWords("palmar medial lateral"),
            Eigen::Vector3d(1, 0, 0));
}

TEST(DirectionOfWordsDeathTest, DiesOfOtherWordsAndOfNone) {
  EXPECT_DEATH(DirectionOfWords("upward"), "no direction: upward");
  EXPECT_DEATH(DirectionOfWords("medial lateral"), "no direction");
  EXPECT_DEATH(DirectionOfWords(""), "no direction");
}

TEST(LongAxisOf, LeadsAwayFromTheTrunk) {
  EXPECT_EQ(LongAxisOf("tibia"), Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(LongAxisOf("metacarpal_2"), Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(LongAxisOf("metatarsal_1"), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(LongAxisOf("foot"), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(LongAxisOf("toe_2_distal"), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(LongAxisOf("clavicle"), Eigen::Vector3d(0, 0, 1));
}

}  // namespace
}  // namespace musclewarp
