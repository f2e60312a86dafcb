// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/skeleton_size.h"

#include <cmath>

#include "musclewarp/joints/joint_search.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// Returns the approximate diagonal of the bounding box of an adult's bone, mm;
// 0 for bones that say too little about the size.
double UsualDiagonal(BoneKind kind) {
  switch (kind) {
    case BoneKind::kPelvis:
      return 370;
    case BoneKind::kHipBone:
      return 280;
    case BoneKind::kFemur:
      return 460;
    case BoneKind::kTibia:
      return 370;
    case BoneKind::kScapula:
      return 220;
    case BoneKind::kHumerus:
      return 330;
    case BoneKind::kUlna:
      return 270;
    case BoneKind::kRadius:
      return 250;
    default:
      return 0;
  }
}

}  // namespace

double SkeletonSizeOf(const std::vector<Bone>& bones) {
  double sum = 0;
  int count = 0;
  for (const Bone& bone : bones) {
    const double usual = UsualDiagonal(bone.kind);
    if (usual == 0 || bone.mesh.points.rows() == 0) continue;
    const double ratio = BoundingBoxDiagonal(bone.mesh.points) / usual;
    if (!(ratio > 0) || !std::isfinite(ratio)) continue;
    sum += std::log2(ratio);
    ++count;
  }
  if (count == 0) return 1;
  const double size = std::exp2(sum / count);
  const BodySearch& search = kJointSearch.body;
  const bool is_human =
      size >= search.least_human && size < search.largest_human;
  if (size < search.least_size || is_human) return 1;
  return std::exp2(std::round(std::log2(size)));
}

void ScaleLengths(double factor, FoundJoint* joint) {
  joint->center *= factor;
  for (FittedShape& shape : joint->shapes) {
    shape.center *= factor;
    shape.radius *= factor;
    shape.spread *= factor;
  }
}

}  // namespace musclewarp
