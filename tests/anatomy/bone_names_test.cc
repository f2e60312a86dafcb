// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/bone_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace musclewarp {
namespace {

using ::testing::Contains;

struct NameCase {
  const char* name;
  BoneKind kind;
  std::optional<Side> side;
};

TEST(ParseBoneName, KnowsNamesOfSegmentationsAndModels) {
  for (const NameCase& known : std::vector<NameCase>{
           {"femur_left", BoneKind::kFemur, Side::kLeft},
           {"hip_right", BoneKind::kHipBone, Side::kRight},
           {"tibia", BoneKind::kTibia, std::nullopt},
           {"tibia_2", BoneKind::kTibia, std::nullopt},
           {"tarsal", BoneKind::kFoot, std::nullopt},
           {"clavicula_left", BoneKind::kClavicle, Side::kLeft},
           {"calcn_r", BoneKind::kFoot, Side::kRight},
           {"R_Femur", BoneKind::kFemur, Side::kRight},
           {"left humerus", BoneKind::kHumerus, Side::kLeft},
           {"pelvis_no_sacrum", BoneKind::kPelvis, std::nullopt},
           {"Os Coxae-L", BoneKind::kHipBone, Side::kLeft},
           {"metatarsal_3", BoneKind::kFoot, std::nullopt},
           {"toe_1_distal", BoneKind::kFoot, std::nullopt},
           {"rib_left_4", BoneKind::kOther, std::nullopt},
           {"vertebrae_L5", BoneKind::kOther, std::nullopt}}) {
    const NamedBone bone = ParseBoneName(known.name);
    EXPECT_TRUE(bone.is_known) << known.name;
    EXPECT_EQ(bone.kind, known.kind) << known.name;
    EXPECT_EQ(bone.side, known.side) << known.name;
  }
}

TEST(ParseBoneName, DoesNotKnowMusclesAndMisspeltBones) {
  for (const char* name : {"gluteus_maximus_right", "femr_r", "l", "", "_"}) {
    EXPECT_FALSE(ParseBoneName(name).is_known) << name;
  }
}

TEST(NearestBoneNames, FindMisspeltNames) {
  EXPECT_THAT(NearestBoneNames("femr_r"), Contains("femur"));
  EXPECT_THAT(NearestBoneNames("left_skapula"), Contains("scapula"));
}

TEST(ParseBoneKind, TakesNamesWithoutSide) {
  EXPECT_EQ(ParseBoneKind("Hip bone"), BoneKind::kHipBone);
  EXPECT_EQ(ParseBoneKind("thing"), std::nullopt);
}

}  // namespace
}  // namespace musclewarp
