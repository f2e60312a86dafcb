// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/standing_bones.h"

#include "musclewarp/anatomy/bone_match.h"

namespace musclewarp {
namespace {

// Leg and shoulder as measured on the man of BodyParts3D (Mitsuhashi et al.
// 2009), spine, forearm and hand estimates of ours. Only directions between
// bones count, for which they are more than good enough.
constexpr StandingBone kStandingBones[] = {
    {"hip_bone", BodyPart::kPelvis, 86, 864, 69},
    {"pelvis", BodyPart::kPelvis, 75, 870, 0},
    {"sacrum", BodyPart::kPelvis, 15, 890, 0},
    {"femur", BodyPart::kThigh, 86, 621, 93},
    {"patella", BodyPart::kThigh, 105, 430, 80},
    {"tibia", BodyPart::kShank, 71, 232, 79},
    {"fibula", BodyPart::kShank, 53, 216, 108},
    {"talus", BodyPart::kFoot, 63, 53, 76},
    {"calcaneus", BodyPart::kFoot, 47, 26, 80},
    {"navicular", BodyPart::kFoot, 94, 47, 75},
    {"cuboid", BodyPart::kFoot, 90, 29, 98},
    {"cuneiform_medial", BodyPart::kFoot, 114, 37, 72},
    {"cuneiform_intermediate", BodyPart::kFoot, 108, 43, 84},
    {"cuneiform_lateral", BodyPart::kFoot, 105, 39, 95},
    {"metatarsal_1", BodyPart::kFoot, 150, 21, 74},
    {"metatarsal_2", BodyPart::kFoot, 147, 24, 92},
    {"metatarsal_3", BodyPart::kFoot, 145, 21, 104},
    {"metatarsal_4", BodyPart::kFoot, 135, 17, 112},
    {"metatarsal_5", BodyPart::kFoot, 121, 11, 120},
    {"toe_1_proximal", BodyPart::kFoot, 191, 5, 77},
    {"toe_1_distal", BodyPart::kFoot, 216, 0, 84},
    {"toe_2_proximal", BodyPart::kFoot, 192, 6, 98},
    {"toe_2_middle", BodyPart::kFoot, 212, 2, 103},
    {"toe_2_distal", BodyPart::kFoot, 224, -1, 105},
    {"toe_3_proximal", BodyPart::kFoot, 187, 4, 112},
    {"toe_3_middle", BodyPart::kFoot, 206, 1, 117},
    {"toe_3_distal", BodyPart::kFoot, 218, -1, 120},
    {"toe_4_proximal", BodyPart::kFoot, 177, 3, 125},
    {"toe_4_middle", BodyPart::kFoot, 194, 1, 131},
    {"toe_4_distal", BodyPart::kFoot, 204, -1, 133},
    {"toe_5_proximal", BodyPart::kFoot, 165, 1, 137},
    {"toe_5_middle", BodyPart::kFoot, 179, -1, 141},
    {"toe_5_distal", BodyPart::kFoot, 186, -2, 143},
    {"foot", BodyPart::kFoot, 122, 22, 92},
    {"tarsals", BodyPart::kFoot, 68, 36, 81},
    {"metatarsals", BodyPart::kFoot, 137, 20, 98},
    {"toes", BodyPart::kFoot, 190, 3, 110},
    {"scapula", BodyPart::kShoulder, 25, 1296, 106},
    {"clavicle", BodyPart::kShoulder, 99, 1354, 82},
    {"humerus", BodyPart::kUpperArm, 66, 1195, 192},
    {"ulna", BodyPart::kForearm, 60, 925, 232},
    {"radius", BodyPart::kForearm, 65, 915, 258},
    {"carpals", BodyPart::kHand, 65, 775, 270},
    {"metacarpal_1", BodyPart::kHand, 85, 745, 300},
    {"metacarpal_2", BodyPart::kHand, 65, 725, 288},
    {"metacarpal_3", BodyPart::kHand, 65, 720, 275},
    {"metacarpal_4", BodyPart::kHand, 65, 725, 262},
    {"metacarpal_5", BodyPart::kHand, 65, 732, 250},
    {"finger_1_proximal", BodyPart::kHand, 95, 715, 320},
    {"finger_1_distal", BodyPart::kHand, 100, 690, 330},
    {"finger_2_proximal", BodyPart::kHand, 65, 665, 292},
    {"finger_2_middle", BodyPart::kHand, 65, 630, 293},
    {"finger_2_distal", BodyPart::kHand, 65, 605, 294},
    {"finger_3_proximal", BodyPart::kHand, 65, 660, 276},
    {"finger_3_middle", BodyPart::kHand, 65, 620, 277},
    {"finger_3_distal", BodyPart::kHand, 65, 593, 277},
    {"finger_4_proximal", BodyPart::kHand, 65, 665, 260},
    {"finger_4_middle", BodyPart::kHand, 65, 630, 260},
    {"finger_4_distal", BodyPart::kHand, 65, 605, 260},
    {"finger_5_proximal", BodyPart::kHand, 65, 680, 244},
    {"finger_5_middle", BodyPart::kHand, 65, 655, 243},
    {"finger_5_distal", BodyPart::kHand, 65, 635, 243},
    {"hand", BodyPart::kHand, 65, 690, 272},
    {"metacarpals", BodyPart::kHand, 67, 727, 272},
    {"fingers", BodyPart::kHand, 66, 640, 272},
    {"sternum", BodyPart::kTrunk, 120, 1240, 0},
    {"skull", BodyPart::kTrunk, 60, 1560, 0},
    {"vertebrae", BodyPart::kTrunk, 30, 1180, 0},
    {"ribs", BodyPart::kTrunk, 60, 1220, 0},
    {"vertebrae_C7", BodyPart::kTrunk, 20, 1400, 0},
    {"vertebrae_T1", BodyPart::kTrunk, 15, 1380, 0},
    {"vertebrae_T4", BodyPart::kTrunk, 0, 1320, 0},
    {"vertebrae_T8", BodyPart::kTrunk, 0, 1220, 0},
    {"vertebrae_T10", BodyPart::kTrunk, 5, 1170, 0},
    {"vertebrae_L1", BodyPart::kTrunk, 25, 1085, 0},
    {"vertebrae_L2", BodyPart::kTrunk, 32, 1052, 0},
    {"vertebrae_L3", BodyPart::kTrunk, 38, 1018, 0},
    {"vertebrae_L4", BodyPart::kTrunk, 40, 984, 0},
    {"vertebrae_L5", BodyPart::kTrunk, 35, 950, 0},
};

}  // namespace

const StandingBone* FindStandingBone(const std::string& name) {
  for (const StandingBone& bone : kStandingBones) {
    if (NamesBone(name, bone.bone)) return &bone;
  }
  return nullptr;
}

}  // namespace musclewarp
