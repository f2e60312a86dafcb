// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_touches.h"

#include <algorithm>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

// Whether points (#P x 3) are farther than a distance from a box, as their own
// box tells.
bool AreApart(const Points& points, const Box3& box, double distance) {
  Box3 around;
  for (int c = 0; c < 3; ++c) {
    around.lower[c] = points.col(c).minCoeff();
    around.upper[c] = points.col(c).maxCoeff();
  }
  return around.SquaredDistance(box) > distance * distance;
}

}  // namespace

// phi is x^3 / 6s up to the onset s and then a parabola with phi'' = 1, so that
// a touch begins without a kink.
BoneForce ForceAt(const BonePush& push, double lack) {
  const double s = push.onset, k = push.stiffness;
  if (lack <= 0) return {};
  if (lack < s) {
    return {k * lack * lack * lack / (6 * s),
            k * lack * lack / (2 * s),
            k * lack / s};
  }
  return {
      k * (lack * lack / 2 - lack * s / 2 + s * s / 6), k * (lack - s / 2), k};
}

std::vector<BoneTouch> TouchesAt(const BonePush& push,
                                 const ScenePose& pose,
                                 const Points& places,
                                 double margin) {
  // Lacks of rounding are no touches.
  constexpr double kLeastLack = 1e-9;  // mm
  std::vector<BoneTouch> touches;
  for (int b = 0; b < static_cast<int>(push.bones.size()); ++b) {
    const Eigen::Matrix4d motion = BodyTransform(pose, push.bones[b].body);
    const Eigen::Matrix3d rotation = motion.topLeftCorner<3, 3>();
    const Points at_rest = Transformed(places, RigidInverse(motion));
    if (AreApart(at_rest,
                 push.bones[b].field->box(),
                 margin + push.clearances.col(b).maxCoeff())) {
      continue;
    }
    DistanceField::Value value;
    for (int v = 0; v < static_cast<int>(at_rest.rows()); ++v) {
      const double kept = push.clearances(v, b) - kLeastLack;
      if (!push.bones[b].field->IsBelow(
              kept + margin, at_rest.row(v), &value)) {
        continue;
      }
      BoneTouch touch;
      touch.sample = v;
      touch.bone = b;
      touch.normal = value.gradient * rotation.transpose();
      touch.curvature = rotation * value.curvature * rotation.transpose();
      touch.lack = kept - value.distance;
      touches.push_back(touch);
    }
  }
  return touches;
}

}  // namespace musclewarp
