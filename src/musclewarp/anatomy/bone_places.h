// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace musclewarp {

// A region on the surface of a bone, in terms of the bone's own shape.
//
// Directions are (anterior, superior, lateral) of a body that stands with its
// palms forward and its feet flat. They hold for both sides of the body, as
// lateral points away from its middle. Plantar is inferior, palmar anterior.
struct BonePlace {
  // "tibia", "metatarsal_1": without side. Every name is one that
  // ParseBoneName() knows; the number tells bones of one kind apart.
  std::string bone;

  // The region lies between these parts of the length of the bone along
  // LongAxisOf(bone): 0 is where the bone begins, 1 where it ends.
  double begin = 0;
  double end = 1;

  // The side of the bone on which it lies, as seen from the middle of that part
  // of the axis; along the axis for what lies at an end, as the back of the
  // heel does. Of length 1.
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
};

// Returns the direction from the beginning to the end of a bone: down for all
// bones but the clavicle (to the acromion) and those of the foot (from the heel
// to the toes). It names the end from which one measures; the axis itself is
// that of the bone's shape. Of length 1.
Eigen::Vector3d LongAxisOf(const std::string& bone);

// Returns the places of a landmark, such as "pes_anserinus", in the order in
// which they are to be looked for: the bones that have it, those next to it
// that may stand in, then those of which they are part where several bones are
// one mesh ("metatarsals", "foot", "pelvis").
// Precondition (CHECKed): it is one of LandmarkNames().
//
// Where a landmark lies is anatomy (H. Gray, Anatomy of the Human Body, 1918,
// II and IV). The parts of lengths are estimates of ours, wide enough for the
// differences between people. Those of pelvis, femur and tibia agree with
// gait2392 (OpenSim); those that muscles of BodyParts3D reach are where those
// muscles touch.
std::vector<BonePlace> PlacesOfLandmark(const std::string& landmark);

// Returns the names of all landmarks, each once.
std::vector<std::string> LandmarkNames();

// Returns the direction that words name, such as "anterior medial", of length
// 1. A word that is there twice weighs twice. Precondition (CHECKed): there are
// such words, and they do not cancel out.
Eigen::Vector3d DirectionOfWords(const std::string& words);

}  // namespace musclewarp
