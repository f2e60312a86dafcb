// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/hip_joint.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <optional>

#include "musclewarp/base/text.h"
#include "musclewarp/joints/joint_building.h"

namespace musclewarp {
namespace {

// The hollow sphere in the hip bone about the head of the femur.
std::optional<SphereFit> FindSocket(const SurfacePoints& hip_bone,
                                    const Sphere& head) {
  constexpr double kReach = 1.6;  // by the radius of the head
  const SurfacePoints near = Filtered(hip_bone, [&](int row) {
    return (hip_bone.points.row(row).transpose() - head.center).norm() <=
           kReach * head.radius;
  });
  return FindSphere(near, {0.8 * head.radius, kReach * head.radius, true});
}

void JudgeHead(const FemurShape& femur, JointVerdict* verdict) {
  constexpr double kWeakCoverage = 0.45;
  constexpr double kWeakSpread = 0.8;  // mm
  const SphereFit& head = *femur.head;
  if (head.coverage < kWeakCoverage) {
    verdict->Weaken("the head covers " + RoundedText(100 * head.coverage, 0) +
                    " % of its sphere, " + RoundedText(100 * kWeakCoverage, 0) +
                    " % or more are expected: it is cut by the image, or a "
                    "part of it is labelled as hip bone");
  }
  if (head.spread > kWeakSpread) {
    verdict->Weaken("the head is off its sphere by " +
                    RoundedText(head.spread, 1) + " mm, at most " +
                    RoundedText(kWeakSpread, 1) +
                    " mm are expected: a deformed head, or a coarse mesh");
  }
}

void SetHipAxes(const Limb& limb, const FemurShape& femur, FoundJoint* joint) {
  const std::optional<Eigen::Matrix3d> pelvis_axes =
      limb.pelvis_axes ? limb.pelvis_axes : limb.image_axes;
  const std::optional<Eigen::Matrix3d> femur_axes = femur.Axes();
  if (pelvis_axes && femur_axes) {
    joint->parent_axes = *pelvis_axes;
    joint->child_axes = *femur_axes;
  } else if (pelvis_axes || femur_axes || limb.image_axes) {
    joint->parent_axes = pelvis_axes  ? *pelvis_axes
                         : femur_axes ? *femur_axes
                                      : *limb.image_axes;
    joint->child_axes = joint->parent_axes;
  } else {
    joint->verdict.Weaken(
        "neither bones nor image say where forward and up are: the axes are "
        "those of the file");
  }
}

}  // namespace

FoundJoint FindHip(const Limb& limb, const FemurShape& femur) {
  constexpr double kWeakOffset = 3;         // mm, of the socket
  constexpr double kLargestDistance = 1.6;  // by the radius of the head
  FoundJoint joint = StartedJoint(JointKind::kHip, limb);
  if (!femur.head) {
    joint.verdict.Fail(
        "no head on the femur: the best sphere of 14 to 32 mm covers " +
        RoundedText(100 * femur.best_coverage, 0) +
        " % of itself, 30 to 95 % are needed; are the meshes in mm, and is the "
        "upper end of the femur there");
    return joint;
  }
  const Sphere& head = femur.head->sphere;
  joint.center = head.center;
  joint.shapes.push_back(ShapeOf("head of the femur", *femur.head));
  JudgeHead(femur, &joint.verdict);
  const SurfacePoints* hip_bone = limb.Find(BoneKind::kHipBone);
  if (hip_bone == nullptr) hip_bone = limb.Find(BoneKind::kPelvis);
  CHECK(hip_bone != nullptr);
  const std::optional<SphereFit> socket = FindSocket(*hip_bone, head);
  const double distance = (hip_bone->points.rowwise() - head.center.transpose())
                              .rowwise()
                              .norm()
                              .minCoeff();
  if (distance > kLargestDistance * head.radius) {
    joint.verdict.Fail("the hip bone is " + RoundedText(distance, 0) +
                       " mm away from the centre of the head, " +
                       RoundedText(kLargestDistance * head.radius, 0) +
                       " mm or less are needed: bones from two scans");
  } else if (!socket) {
    joint.verdict.Weaken(
        "no socket was found about the head of the femur: bones from two "
        "scans, or a hip bone that is cut");
  } else {
    joint.shapes.push_back(ShapeOf("socket of the hip bone", *socket));
    joint.shapes.back().is_on_parent = true;
    const double offset = (socket->sphere.center - head.center).norm();
    if (offset > kWeakOffset) {
      joint.verdict.Weaken(
          "the socket is " + RoundedText(offset, 1) +
          " mm off the head, at most " + RoundedText(kWeakOffset, 0) +
          " mm are expected: bones from two scans, or a dislocation");
    }
  }
  SetHipAxes(limb, femur, &joint);
  return joint;
}

}  // namespace musclewarp
