// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee_verdict.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/joint_building.h"

namespace musclewarp {
namespace {

// Signs that the lower end of the femur is not there, and something else was
// taken for condyles. They need the head.
void JudgeLowerEnd(const FemurShape& femur, JointVerdict* verdict) {
  constexpr double kLeastBackToFront = 1.5;
  constexpr double kLeastLength = 8;  // by the radius of the head
  if (!femur.head) return;
  const double length =
      (femur.head->sphere.center - femur.knee->cylinder.axis.point).norm() /
      femur.head->sphere.radius;
  const double back_to_front = femur.directions->back_to_front;
  if (back_to_front >= kLeastBackToFront && length >= kLeastLength) return;
  verdict->Fail("no condyles: the lower end reaches back " +
                RoundedText(back_to_front, 1) +
                " times as far as forward (1.5 or more are needed) and is " +
                RoundedText(length, 1) +
                " radii of the head away from it (8 or more): a femur without "
                "its lower end");
}

void JudgeAxis(const FemurShape& femur, JointVerdict* verdict) {
  constexpr double kLargestTurn = RadiansOf(30);
  constexpr double kFailedSphereAngle = RadiansOf(20);
  constexpr double kWeakSphereAngle = RadiansOf(5);
  const KneeFit& knee = *femur.knee;
  const double turn = std::acos(std::min(
      1.0, std::abs(knee.cylinder.axis.direction.dot(femur.directions->left))));
  if (turn > kLargestTurn) {
    verdict->Fail("no condyles: the cylinder that fits best is " +
                  DegreesText(turn) +
                  " off the widest direction of the lower end, 30 or less are "
                  "needed");
    return;
  }
  const std::string spheres = "spheres on both condyles give an axis that is " +
                              DegreesText(knee.sphere_angle, 1) + " off, ";
  if (knee.sphere_angle > kFailedSphereAngle) {
    verdict->Fail(spheres + "20 or less are needed");
  } else if (knee.sphere_angle > kWeakSphereAngle) {
    verdict->Weaken(spheres +
                    "5 or less are expected: osteophytes, or a coarse mesh");
  }
}

void JudgeSurface(const KneeFit& knee, JointVerdict* verdict) {
  constexpr double kFailedAngle = RadiansOf(30), kWeakAngle = RadiansOf(60);
  constexpr double kWeakSpread = 1;  // mm
  const double angle = std::min(knee.left_angle, knee.right_angle);
  const std::string covered =
      "a condyle covers " + DegreesText(angle) + " of its cylinder, ";
  if (angle < kFailedAngle) {
    verdict->Fail(covered + "30 or more are needed");
  } else if (angle < kWeakAngle) {
    verdict->Weaken(covered + "60 or more are expected: cut or coarse bone");
  }
  if (knee.spread > kWeakSpread) {
    verdict->Weaken("the condyles are off their cylinder by " +
                    RoundedText(knee.spread, 1) +
                    " mm, 1 mm or less is expected");
  }
}

}  // namespace

JointVerdict JudgeKnee(const FemurShape& femur) {
  CHECK(femur.knee);
  JointVerdict verdict;
  JudgeLowerEnd(femur, &verdict);
  JudgeAxis(femur, &verdict);
  JudgeSurface(*femur.knee, &verdict);
  if (!femur.is_up_known) {
    verdict.Weaken(
        "neither a head nor the image tells which end of the femur is up: the "
        "condyles may be looked at from the wrong side");
  }
  return verdict;
}

}  // namespace musclewarp
