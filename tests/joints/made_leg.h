// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "joints/ideal_surfaces.h"
#include "musclewarp/anatomy/bone.h"
#include "musclewarp/mesh/connectivity.h"
#include "support/made_bones.h"
#include "support/meshes.h"

namespace musclewarp {

// A femur without a side in its name, a plain tibia below it, and a block with
// a socket about its head, which stands in for a pelvis.
struct MadeLeg {
  MadeFemur femur;
  std::vector<Bone> bones;  // femur, tibia, pelvis
};

inline TriangleSoup MovedTo(TriangleSoup soup, const Eigen::Vector3d& way) {
  soup.points.rowwise() += way.transpose();
  return soup;
}

inline MadeLeg LegOf(Side side) {
  MadeLeg leg;
  static const auto* made = new MadeFemur(RightFemur(3));
  static const auto* socket = new MadeSocket(BlockWithSocket(3));
  const MadeFemur& right = *made;
  leg.femur = side == Side::kRight ? right : Mirrored(right);
  TriangleSoup tibia = Box(40, 40, 300);
  const Eigen::Vector3d middle = tibia.points.colwise().mean().transpose();
  tibia = MovedTo(tibia,
                  leg.femur.knee.point - middle - Eigen::Vector3d(0, 0, 180));
  leg.bones = {{"femur", BoneKind::kFemur, std::nullopt, "", leg.femur.surface},
               {"tibia", BoneKind::kTibia, std::nullopt, "", tibia},
               {"pelvis",
                BoneKind::kPelvis,
                std::nullopt,
                "",
                MovedTo(socket->surface, leg.femur.head - socket->center)}};
  return leg;
}

// The same with a patella of 40 x 20 x 40 mm before the groove of the femur.
inline std::vector<Bone> LegWithPatella(Side side) {
  std::vector<Bone> bones = LegOf(side).bones;
  TriangleSoup patella = Icosphere(20, 3);
  patella.points.col(1) *= 0.5;
  bones.push_back({"patella",
                   BoneKind::kPatella,
                   std::nullopt,
                   "",
                   MovedTo(patella, {0, -45, 15})});
  return bones;
}

}  // namespace musclewarp
