// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/hip_joint.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <optional>

#include "musclewarp/joints/joint_building.h"
#include "musclewarp/joints/joint_limits.h"
#include "musclewarp/joints/joint_search.h"

namespace musclewarp {
namespace {

// The hollow sphere in the hip bone about the head of the femur.
std::optional<SphereFit> FindSocket(const SurfacePoints& hip_bone,
                                    const Sphere& head) {
  const SurfacePoints near = Filtered(hip_bone, [&](int row) {
    return (hip_bone.points.row(row).transpose() - head.center).norm() <=
           kJointSearch.head.largest_socket * head.radius;
  });
  return FindSphere(near,
                    {kJointSearch.head.least_socket * head.radius,
                     kJointSearch.head.largest_socket * head.radius,
                     true});
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
    Judge({{kJointLimits.hip.no_axes}}, &joint->verdict);
  }
}

}  // namespace

FoundJoint FindHip(const Limb& limb, const FemurShape& femur) {
  const HipLimits& limits = kJointLimits.hip;
  FoundJoint joint = StartedJoint(JointKind::kHip, limb);
  const double coverage = 100 * femur.best_coverage;
  Judge({{limits.coverage, coverage}, {limits.ball, coverage}}, &joint.verdict);
  if (!femur.head) return joint;
  const Sphere& head = femur.head->sphere;
  joint.center = head.center;
  joint.shapes.push_back(ShapeOf("head of the femur", *femur.head));
  Judge({{limits.spread, femur.head->spread}}, &joint.verdict);
  const SurfacePoints* hip_bone = limb.Find(BoneKind::kHipBone);
  if (hip_bone == nullptr) hip_bone = limb.Find(BoneKind::kPelvis);
  CHECK(hip_bone != nullptr);
  const std::optional<SphereFit> socket = FindSocket(*hip_bone, head);
  const double distance = (hip_bone->points.rowwise() - head.center.transpose())
                              .rowwise()
                              .norm()
                              .minCoeff();
  const bool is_apart = Judge({{limits.distance, distance, head.radius}},
                              &joint.verdict) == JointQuality::kFailed;
  if (!is_apart && !socket) {
    Judge({{limits.no_socket}}, &joint.verdict);
  } else if (!is_apart) {
    joint.shapes.push_back(ShapeOf("socket of the hip bone", *socket));
    joint.shapes.back().is_on_parent = true;
    const double offset = (socket->sphere.center - head.center).norm();
    Judge({{limits.offset, offset}}, &joint.verdict);
  }
  SetHipAxes(limb, femur, &joint);
  return joint;
}

}  // namespace musclewarp
