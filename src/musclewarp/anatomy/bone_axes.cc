// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/bone_axes.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

#include "musclewarp/anatomy/bone_match.h"
#include "musclewarp/anatomy/bone_places.h"
#include "musclewarp/anatomy/standing_bones.h"

namespace musclewarp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// What the bones of other parts of the limb count against those of the same
// part, and the frame of the image where bones say nothing.
constexpr double kOfOtherParts = 0.2;
constexpr double kOfImage = 0.02;
// Bones nearer to each other than this count less, mm: their centres tell the
// direction less well.
constexpr double kNearBones = 40;
// A bone is long if its ends are farther apart than this, mm, and its axis
// counts this much.
constexpr double kLongBone = 150;
constexpr double kOfAxis = 1;
// The directions are open if turning them costs less than this share of what
// the fit gives.
constexpr double kOpen = 0.02;

// A bone of the scene, and where it lies in a standing body.
struct KnownBone {
  const StandingBone* standing;
  Points ends;  // of its long axis, 2 x 3, mm

  Vector3d Middle() const { return ends.colwise().mean().transpose(); }
  Vector3d Along() const { return (ends.row(1) - ends.row(0)).transpose(); }
};

std::optional<KnownBone> KnownBoneOf(const MeasuredBone& bone) {
  const StandingBone* standing = FindStandingBone(bone.bone.name);
  if (!standing || bone.ends.rows() == 0) return std::nullopt;
  return KnownBone{standing, bone.ends};
}

// The sum of weight * (direction in the scene) * (the same in the body)^T.
using Evidence = Matrix3d;

void AddDirection(double weight,
                  const Vector3d& in_scene,
                  const Vector3d& in_body,
                  Evidence* evidence) {
  *evidence +=
      weight * in_scene.normalized() * in_body.normalized().transpose();
}

// The directions that fit best, how well they do, and what turning them costs
// at least.
struct Fit {
  Matrix3d directions;
  double score = 0;
  double cost_of_turning = 0;
};

// Returns the directions with the determinant `handedness` that fit best.
Fit FitTo(const Evidence& evidence, double handedness) {
  const Eigen::JacobiSVD<Matrix3d> svd(
      evidence, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign =
      handedness * (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0
          ? -1
          : 1;
  const Vector3d& values = svd.singularValues();
  Fit fit;
  fit.directions = svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() *
                   svd.matrixV().transpose();
  fit.score = values[0] + values[1] + sign * values[2];
  fit.cost_of_turning = values[1] + sign * values[2];
  return fit;
}

bool IsOpen(const Fit& fit) { return fit.cost_of_turning < kOpen * fit.score; }

// Returns where bones lie from those of one part of the body, and the axes of
// the long ones among these. Which end of an axis is which follows from the
// places, and from the image where these do not tell.
Evidence EvidenceOf(BodyPart part,
                    const std::vector<KnownBone>& known,
                    const Evidence& of_image) {
  Evidence evidence = Evidence::Zero();
  for (const KnownBone& from : known) {
    if (from.standing->part != part) continue;
    for (const KnownBone& to : known) {
      const Vector3d in_body = to.standing->Middle() - from.standing->Middle();
      const Vector3d in_scene = to.Middle() - from.Middle();
      if (in_body.isZero() || in_scene.isZero()) continue;
      const double near = std::min(1.0, in_body.norm() / kNearBones);
      AddDirection(near * (to.standing->part == part ? 1 : kOfOtherParts),
                   in_scene,
                   in_body,
                   &evidence);
    }
  }
  const Evidence of_places = evidence + of_image;
  for (const KnownBone& bone : known) {
    const Vector3d along = bone.Along();
    if (bone.standing->part != part || along.norm() < kLongBone) continue;
    const Vector3d down = LongAxisOf(bone.standing->bone);
    const bool is_forward = along.dot(of_places * down) >= 0;
    AddDirection(
        kOfAxis, is_forward ? along : Vector3d(-along), down, &evidence);
  }
  return evidence;
}

Matrix3d MirroredForLeft(Matrix3d image, double handedness) {
  if (handedness < 0) image.col(2) *= -1;
  return image;
}

}  // namespace

BoneAxes AxesAt(size_t bone,
                const std::vector<MeasuredBone>& bones,
                const std::optional<Side>& side,
                const Matrix3d& image) {
  std::vector<KnownBone> known;
  for (const MeasuredBone& other : bones) {
    if (side && other.bone.side && *side != *other.bone.side) continue;
    if (const auto entry = KnownBoneOf(other)) known.push_back(*entry);
  }
  const auto own = KnownBoneOf(bones[bone]);
  BoneAxes best;
  double best_score = -1;
  for (const double handedness : {1.0, -1.0}) {
    if (side && (*side == Side::kRight) != (handedness > 0)) continue;
    // Lateral is to the right on the right.
    const Evidence of_image = kOfImage * MirroredForLeft(image, handedness);
    const Evidence evidence =
        own ? EvidenceOf(own->standing->part, known, of_image)
            : Evidence(Evidence::Zero());
    Fit fit = FitTo(evidence, handedness);
    const bool is_open = fit.score == 0 || IsOpen(fit);
    if (is_open) fit = FitTo(evidence + of_image, handedness);
    if (fit.score <= best_score) continue;
    best_score = fit.score;
    best = {fit.directions, !is_open};
  }
  return best;
}

}  // namespace musclewarp
