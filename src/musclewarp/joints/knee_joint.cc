// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee_joint.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "musclewarp/base/text.h"
#include "musclewarp/joints/joint_building.h"
#include "musclewarp/joints/knee_verdict.h"

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
  joint.verdict = JudgeKnee(femur);
  constexpr double kLargestGap = 2;  // by the radius of the head
  const double gap = (tibia->points.rowwise() - joint.center.transpose())
                         .rowwise()
                         .norm()
                         .minCoeff();
  if (gap > kLargestGap * femur.HeadRadius()) {
    joint.verdict.Fail("the tibia is " + RoundedText(gap, 0) +
                       " mm away from the centre of the knee, " +
                       RoundedText(kLargestGap * femur.HeadRadius(), 0) +
                       " mm or less are needed: of another leg or scan");
  }
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
