// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee_joint.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "musclewarp/joints/joint_building.h"

namespace musclewarp {
namespace {

// The middle of the lower end of a tibia, which is that of the ankle.
Eigen::Vector3d LowerEndOf(const SurfacePoints& tibia,
                           const Eigen::Vector3d& knee) {
  constexpr double kLastPart = 0.05;  // of the length
  Eigen::VectorXd distance =
      (tibia.points.rowwise() - knee.transpose()).rowwise().norm();
  const double farthest = distance.maxCoeff();
  const SurfacePoints end = Filtered(tibia, [&](int row) {
    return distance[row] >= (1 - kLastPart) * farthest;
  });
  return end.points.colwise().mean().transpose();
}

void JudgeKnee(const FemurShape& femur, JointVerdict* verdict) {
  constexpr double kFailedAngle = 30 * kDegree, kWeakAngle = 60 * kDegree;
  constexpr double kLeastBackToFront = 1.5, kLeastLength = 8;
  constexpr double kWeakSphereAngle = 5 * kDegree;
  constexpr double kWeakSpread = 1.0;  // mm
  const KneeFit& knee = *femur.knee;
  const double angle = std::min(knee.left_angle, knee.right_angle);
  if (femur.head) {
    const double length =
        (femur.head->sphere.center - knee.cylinder.axis.point).norm() /
        femur.head->sphere.radius;
    if (femur.directions->back_to_front < kLeastBackToFront ||
        length < kLeastLength) {
      verdict->Fail(
          "no condyles: the lower end reaches back " +
          Rounded(femur.directions->back_to_front, 1) +
          " times as far as forward (1.5 or more are needed) and is " +
          Rounded(length, 1) +
          " radii of the head away from it (8 or more): a part of the femur "
          "without its lower end");
      return;
    }
  }
  const std::string covered = "the condyles cover " +
                              Rounded(angle / kDegree, 0) +
                              " degrees of their cylinder";
  if (angle < kFailedAngle) {
    verdict->Fail(covered + ", 30 or more are needed");
  } else if (angle < kWeakAngle) {
    verdict->Weaken(covered + ", 60 or more are expected: cut or coarse bone");
  }
  if (knee.sphere_angle > kWeakSphereAngle) {
    verdict->Weaken("spheres on both condyles give an axis that is " +
                    Rounded(knee.sphere_angle / kDegree, 1) +
                    " degrees off, 5 or less are expected: osteophytes, or a "
                    "coarse mesh");
  }
  if (knee.spread > kWeakSpread) {
    verdict->Weaken("the condyles are off their cylinder by " +
                    Rounded(knee.spread, 1) + " mm, 1 mm or less is expected");
  }
}

}  // namespace

FoundJoint FindKnee(const Limb& limb, const FemurShape& femur) {
  FoundJoint joint = StartedJoint(JointKind::kKnee, limb);
  const SurfacePoints* tibia = limb.Find(BoneKind::kTibia);
  CHECK(tibia != nullptr);
  if (!femur.knee) {
    joint.verdict.Fail(
        "no cylinder fits two condyles of the femur: its lower "
        "end is not there, or the meshes are not in mm");
    return joint;
  }
  const KneeFit& knee = *femur.knee;
  joint.center = knee.cylinder.axis.point;
  joint.shapes.push_back(ShapeOf("posterior condyles of the femur",
                                 knee.cylinder,
                                 knee.spread,
                                 std::min(knee.left_angle, knee.right_angle)));
  joint.shapes.back().is_on_parent = true;
  JudgeKnee(femur, &joint.verdict);
  const Eigen::Vector3d right = -knee.cylinder.axis.direction;
  const Eigen::Vector3d up_of_femur =
      femur.head ? Eigen::Vector3d(femur.head->sphere.center - joint.center)
                 : femur.directions->up;
  joint.parent_axes = AxesAlong(2, right, 1, up_of_femur);
  joint.child_axes =
      AxesAlong(2, right, 1, joint.center - LowerEndOf(*tibia, joint.center));
  return joint;
}

}  // namespace musclewarp
