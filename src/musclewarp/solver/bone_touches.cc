// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_touches.h"

#include <algorithm>

#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {

// phi is x^3 / 6s up to the onset s and then a parabola with phi'' = 1, so that
// a touch begins without a kink.
BoneForce ForceAt(const BonePush& push, double lack) {
  const double s = push.options.onset, k = push.stiffness;
  if (lack <= 0) return {};
  if (lack < s) {
    return {k * lack * lack * lack / (6 * s),
            k * lack * lack / (2 * s),
            k * lack / s};
  }
  return {
      k * (lack * lack / 2 - lack * s / 2 + s * s / 6), k * (lack - s / 2), k};
}

BoneTouches::BoneTouches(const BonePush& push) : push_(push) {
  const Eigen::Index count = push.fine_from_coarse.rows();
  seen_.assign(push.bones.size(),
               {Points::Zero(count, 3), Eigen::VectorXd::Zero(count)});
}

std::vector<BoneTouch> BoneTouches::At(const ScenePose& pose,
                                       const Points& places,
                                       double margin) {
  // Lacks of rounding are no touches.
  constexpr double kLeastLack = 1e-9;  // mm
  const Box3 box = BoxOf(places);
  std::vector<BoneTouch> touches;
  for (int b = 0; b < static_cast<int>(push_.bones.size()); ++b) {
    const DistanceField& field = *push_.bones[b].field;
    const Eigen::Matrix4d motion = BodyTransform(pose, push_.bones[b].body);
    // Most bones are far from most muscles.
    const double near =
        std::max(0.0, margin + push_.clearances.col(b).maxCoeff());
    const Box3 bone = Transformed(field.box(), motion);
    if (box.SquaredDistance(bone) > near * near) continue;
    const Eigen::Matrix3d rotation = motion.topLeftCorner<3, 3>();
    const Points at_rest = Transformed(places, RigidInverse(motion));
    Seen& seen = seen_[b];
    DistanceField::Value value;
    for (int v = 0; v < static_cast<int>(at_rest.rows()); ++v) {
      const double kept = push_.clearances(v, b) - kLeastLack;
      const double limit = kept + margin;
      const double still = seen.bounds[v] - limit;
      if (still > 0 &&
          (at_rest.row(v) - seen.places.row(v)).squaredNorm() < still * still) {
        continue;
      }
      seen.places.row(v) = at_rest.row(v);
      seen.bounds[v] = field.LowerBound(at_rest.row(v));
      if (seen.bounds[v] > limit) continue;
      if (!field.IsBelow(limit, at_rest.row(v), &value)) continue;
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
