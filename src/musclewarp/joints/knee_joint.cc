// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee_joint.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "musclewarp/joints/joint_building.h"
#include "musclewarp/joints/joint_limits.h"
#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/knee_verdict.h"

namespace musclewarp {
namespace {

// Returns the middle of the lower end of a tibia, where the ankle is.
Eigen::Vector3d LowerEndOf(const SurfacePoints& tibia,
                           const Eigen::Vector3d& knee) {
  Eigen::VectorXd distance =
      (tibia.points.rowwise() - knee.transpose()).rowwise().norm();
  const double farthest = distance.maxCoeff();
  const SurfacePoints end = Filtered(tibia, [&](int row) {
    return distance[row] >= (1 - kJointSearch.knee.ankle_part) * farthest;
  });
  return end.points.colwise().mean().transpose();
}

}  // namespace

FoundJoint FindKnee(const Limb& limb, const FemurShape& femur) {
  FoundJoint joint = StartedJoint(JointKind::kKnee, limb);
  const SurfacePoints* tibia = limb.Find(BoneKind::kTibia);
  CHECK(tibia != nullptr);
  if (!femur.knee) {
    Judge({{kJointLimits.knee.no_cylinder}}, &joint.verdict);
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
  const double gap = (tibia->points.rowwise() - joint.center.transpose())
                         .rowwise()
                         .norm()
                         .minCoeff();
  Judge({{kJointLimits.knee.gap, gap, femur.HeadRadius()}}, &joint.verdict);
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
