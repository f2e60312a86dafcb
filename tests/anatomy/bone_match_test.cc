// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/bone_match.h"

#include <gtest/gtest.h>

#include "musclewarp/anatomy/bone_places.h"

namespace musclewarp {
namespace {

TEST(NamesBone, IsTrueOfOtherNamesOfABone) {
  EXPECT_TRUE(NamesBone("calcn_r", "calcaneus"));
  EXPECT_TRUE(NamesBone("First metatarsal bone, right", "metatarsal_1"));
  EXPECT_TRUE(NamesBone("metatarsal1_left", "metatarsal_1"));
  EXPECT_TRUE(NamesBone("medial_cuneiform_l", "cuneiform_medial"));
  EXPECT_TRUE(NamesBone("distal phalanx of first toe", "toe_1_distal"));
  EXPECT_TRUE(NamesBone("phalanges_feet", "toes"));
  EXPECT_TRUE(NamesBone("metatarsal", "metatarsals"));
  EXPECT_TRUE(NamesBone("hip_left", "hip_bone"));
  EXPECT_TRUE(NamesBone("vertebrae_L3", "vertebrae_L3"));
}

TEST(NamesBone, IsFalseOfOtherBones) {
  EXPECT_FALSE(NamesBone("metatarsal_1", "metatarsal_2"));
  EXPECT_FALSE(NamesBone("metatarsal_1", "metatarsals"));
  EXPECT_FALSE(NamesBone("toe_1_distal", "toe_1_proximal"));
  EXPECT_FALSE(NamesBone("tibia", "fibula"));
  EXPECT_FALSE(NamesBone("vertebrae_L3", "vertebrae_L2"));
  EXPECT_FALSE(NamesBone("foot", "tarsals"));
  EXPECT_FALSE(NamesBone("finger_1_distal", "toe_1_distal"));
}

TEST(NamesBone, IsTrueOfAllNamesInTheTables) {
  for (const std::string& landmark : LandmarkNames()) {
    for (const BonePlace& place : PlacesOfLandmark(landmark)) {
      EXPECT_TRUE(NamesBone(place.bone + "_right", place.bone)) << place.bone;
    }
  }
}

}  // namespace
}  // namespace musclewarp
