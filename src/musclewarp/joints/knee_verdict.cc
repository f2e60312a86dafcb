// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee_verdict.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/base/angles.h"
#include "musclewarp/joints/joint_limits.h"

namespace musclewarp {
namespace {

// Judges whether the lower end of the femur is missing and another surface was
// taken for condyles. This needs the head.
void JudgeLowerEnd(const FemurShape& femur, JointVerdict* verdict) {
  if (!femur.head) return;
  const double length =
      (femur.head->sphere.center - femur.knee->cylinder.axis.point).norm() /
      femur.head->sphere.radius;
  Judge({{kJointLimits.knee.back_to_front, femur.directions->back_to_front},
         {kJointLimits.knee.length, length}},
        verdict);
}

void JudgeAxis(const FemurShape& femur, JointVerdict* verdict) {
  const KneeFit& knee = *femur.knee;
  const double turn = std::acos(std::min(
      1.0, std::abs(knee.cylinder.axis.direction.dot(femur.directions->left))));
  if (Judge({{kJointLimits.knee.turn, DegreesOf(turn)}}, verdict) ==
      JointQuality::kGood) {
    Judge({{kJointLimits.knee.sphere_angle, DegreesOf(knee.sphere_angle)}},
          verdict);
  }
}

}  // namespace

JointVerdict JudgeKnee(const FemurShape& femur) {
  CHECK(femur.knee);
  const KneeFit& knee = *femur.knee;
  JointVerdict verdict;
  JudgeLowerEnd(femur, &verdict);
  JudgeAxis(femur, &verdict);
  const double angle = std::min(knee.left_angle, knee.right_angle);
  Judge({{kJointLimits.knee.angle, DegreesOf(angle)}}, &verdict);
  Judge({{kJointLimits.knee.spread, knee.spread}}, &verdict);
  if (!femur.is_up_known) Judge({{kJointLimits.knee.is_up_unknown}}, &verdict);
  return verdict;
}

}  // namespace musclewarp
