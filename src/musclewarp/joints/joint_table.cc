// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/joint_table.h"

#include <glog/logging.h>

namespace musclewarp {
namespace {

struct CoordinateEntry {
  const char* name;
  Eigen::Vector3d axis;  // of a right joint
  double lowest, highest;
};

struct JointEntry {
  JointKind kind;
  const char* name;
  BoneKind parent, child;
  std::vector<CoordinateEntry> coordinates;
};

// Angles in degrees; ranges are those in which most people move.
const std::vector<JointEntry>& Entries() {
  static const auto* entries = new std::vector<JointEntry>{
      {JointKind::kHip,
       "hip",
       BoneKind::kPelvis,
       BoneKind::kFemur,
       {{"hip_flexion", {0, 0, 1}, -30, 120},
        {"hip_adduction", {1, 0, 0}, -50, 30},
        {"hip_rotation", {0, 1, 0}, -40, 40}}},
      {JointKind::kKnee,
       "knee",
       BoneKind::kFemur,
       BoneKind::kTibia,
       {{"knee_angle", {0, 0, -1}, 0, 120}}},
      {JointKind::kPatella,
       "patella",
       BoneKind::kFemur,
       BoneKind::kPatella,
       {{"patella_angle", {0, 0, -1}, 0, 120}}},
      {JointKind::kAnkle,
       "ankle",
       BoneKind::kTibia,
       BoneKind::kTalus,
       {{"ankle_angle", {0, 0, 1}, -40, 30}}},
      {JointKind::kSubtalar,
       "subtalar",
       BoneKind::kTalus,
       BoneKind::kFoot,
       {{"subtalar_angle", {1, 0, 0}, -20, 20}}},
      {JointKind::kShoulder,
       "shoulder",
       BoneKind::kScapula,
       BoneKind::kHumerus,
       {{"arm_flex", {0, 0, 1}, -90, 90},
        {"arm_add", {1, 0, 0}, -90, 90},
        {"arm_rot", {0, 1, 0}, -90, 90}}},
      {JointKind::kElbow,
       "elbow",
       BoneKind::kHumerus,
       BoneKind::kUlna,
       {{"elbow_flex", {0, 0, 1}, 0, 150}}},
      {JointKind::kForearm,
       "forearm",
       BoneKind::kUlna,
       BoneKind::kRadius,
       {{"pro_sup", {0, 1, 0}, 0, 90}}},
  };
  return *entries;
}

const JointEntry& EntryOf(JointKind kind) {
  for (const JointEntry& entry : Entries()) {
    if (entry.kind == kind) return entry;
  }
  LOG(FATAL) << "no entry for joint kind " << static_cast<int>(kind);
}

}  // namespace

const std::vector<JointKind>& AllJointKinds() {
  static const auto* kinds = [] {
    auto* all = new std::vector<JointKind>;
    for (const JointEntry& entry : Entries()) all->push_back(entry.kind);
    return all;
  }();
  return *kinds;
}

std::string ToString(JointKind kind) { return EntryOf(kind).name; }

std::string JointName(JointKind kind, Side side) {
  return EntryOf(kind).name + SuffixOf(side);
}

std::string ParentBody(JointKind kind, Side side) {
  return BodyOf(EntryOf(kind).parent, side);
}

std::string ChildBody(JointKind kind, Side side) {
  return BodyOf(EntryOf(kind).child, side);
}

std::vector<JointCoordinate> CoordinatesOf(JointKind kind, Side side) {
  std::vector<JointCoordinate> coordinates;
  for (const CoordinateEntry& entry : EntryOf(kind).coordinates) {
    Eigen::Vector3d axis = entry.axis;
    // A mirror reverses turns about the axes that lie in it.
    if (side == Side::kLeft) axis.head<2>() = -axis.head<2>();
    coordinates.push_back(
        {entry.name + SuffixOf(side), axis, entry.lowest, entry.highest});
  }
  return coordinates;
}

std::string BodyOf(BoneKind kind, Side side) {
  switch (kind) {
    case BoneKind::kOther:
      return "";
    case BoneKind::kPelvis:
    case BoneKind::kHipBone:
    case BoneKind::kSacrum:
      return "pelvis";
    case BoneKind::kFemur:
      return "femur" + SuffixOf(side);
    case BoneKind::kPatella:
      return "patella" + SuffixOf(side);
    case BoneKind::kTibia:
    case BoneKind::kFibula:
      return "tibia" + SuffixOf(side);
    case BoneKind::kTalus:
      return "talus" + SuffixOf(side);
    case BoneKind::kFoot:
      return "calcn" + SuffixOf(side);
    case BoneKind::kScapula:
    case BoneKind::kClavicle:
      return "scapula" + SuffixOf(side);
    case BoneKind::kHumerus:
      return "humerus" + SuffixOf(side);
    case BoneKind::kUlna:
      return "ulna" + SuffixOf(side);
    case BoneKind::kRadius:
      return "radius" + SuffixOf(side);
  }
  return "";
}

}  // namespace musclewarp
