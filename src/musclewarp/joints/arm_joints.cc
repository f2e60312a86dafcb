// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/arm_joints.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <optional>

#include "musclewarp/base/angles.h"
#include "musclewarp/joints/facing_surface.h"
#include "musclewarp/joints/joint_building.h"
#include "musclewarp/joints/joint_limits.h"
#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/point_search.h"
#include "musclewarp/joints/revolution_fit.h"

namespace musclewarp {
namespace {

const SurfacePoints& Needed(const Limb& limb, BoneKind kind) {
  const SurfacePoints* surface = limb.Find(kind);
  CHECK(surface != nullptr);
  return *surface;
}

Eigen::Vector3d MiddleOf(const SurfacePoints& surface) {
  return surface.points.colwise().mean().transpose();
}

// The middle of the end of a long bone that is farther from a place.
Eigen::Vector3d FarEndOf(const SurfacePoints& bone,
                         const Eigen::Vector3d& place) {
  const Eigen::VectorXd distance =
      (bone.points.rowwise() - place.transpose()).rowwise().norm();
  const double farthest = distance.maxCoeff();
  return MiddleOf(Filtered(bone, [&](int row) {
    return distance[row] >= (1 - kJointSearch.body.end_part) * farthest;
  }));
}

// The surface of the humerus that looks at the bones of the forearm.
SurfacePoints ElbowSurface(const Limb& limb) {
  const SurfacePoints& ulna = Needed(limb, BoneKind::kUlna);
  const SurfacePoints* radius = limb.Find(BoneKind::kRadius);
  SurfacePoints forearm = ulna;
  if (radius != nullptr) {
    forearm.points.conservativeResize(ulna.size() + radius->size(), 3);
    forearm.normals.conservativeResize(ulna.size() + radius->size(), 3);
    forearm.points.bottomRows(radius->size()) = radius->points;
    forearm.normals.bottomRows(radius->size()) = radius->normals;
  }
  return FacingSurface(Needed(limb, BoneKind::kHumerus), forearm);
}

// The right of the body at an elbow: the radius is on the outer side; without
// one the image tells.
std::optional<Eigen::Vector3d> RightAtElbow(const Limb& limb) {
  if (const SurfacePoints* radius = limb.Find(BoneKind::kRadius)) {
    const Eigen::Vector3d outward =
        MiddleOf(*radius) - MiddleOf(Needed(limb, BoneKind::kUlna));
    return limb.side == Side::kRight ? outward : Eigen::Vector3d(-outward);
  }
  if (limb.image_axes) return limb.image_axes->col(2);
  return std::nullopt;
}

FittedShape AxisShape(const std::string& what, const Axis& axis) {
  FittedShape shape;
  shape.what = what;
  shape.kind = FittedShape::Kind::kAxis;
  shape.center = axis.point;
  shape.direction = axis.direction;
  return shape;
}

}  // namespace

FoundJoint FindShoulder(const Limb& limb) {
  const ShoulderLimits& limits = kJointLimits.shoulder;
  FoundJoint joint = StartedJoint(JointKind::kShoulder, limb);
  const std::optional<SphereFit> head =
      FindSphere(Needed(limb, BoneKind::kHumerus), {});
  const double coverage = head ? 100 * head->coverage : 0;
  if (Judge({{limits.coverage, coverage}}, &joint.verdict) ==
      JointQuality::kFailed) {
    return joint;
  }
  joint.center = head->sphere.center;
  joint.shapes.push_back(ShapeOf("head of the humerus", *head));
  Judge({{limits.spread, head->spread}}, &joint.verdict);
  if (limb.image_axes) {
    joint.parent_axes = *limb.image_axes;
  } else {
    Judge({{limits.no_axes}}, &joint.verdict);
  }
  joint.child_axes = joint.parent_axes;
  return joint;
}

FoundJoint FindElbow(const Limb& limb) {
  const ElbowLimits& limits = kJointLimits.elbow;
  FoundJoint joint = StartedJoint(JointKind::kElbow, limb);
  const SurfacePoints& humerus = Needed(limb, BoneKind::kHumerus);
  const SurfacePoints facing = ElbowSurface(limb);
  const std::optional<RevolutionFit> fit = FitRevolution(facing);
  const double angle =
      fit ? DegreesOf(AngleCovered(facing.points, fit->axis)) : 0;
  const JointQuality quality = QualityOf({limits.angle, angle});
  if (quality == JointQuality::kFailed) {
    Judge({{limits.angle, angle}}, &joint.verdict);
    return joint;
  }
  Axis axis = fit->axis;
  const std::optional<Eigen::Vector3d> right = RightAtElbow(limb);
  if (right && axis.direction.dot(*right) < 0) axis.direction *= -1;
  if (!right) Judge({{limits.no_right}}, &joint.verdict);
  joint.shapes.push_back(AxisShape("trochlea and capitulum", axis));
  joint.shapes.back().spread = fit->spread;
  joint.shapes.back().angle = AngleCovered(facing.points, fit->axis);
  joint.shapes.back().is_on_parent = true;
  Judge({{limits.angle, angle}}, &joint.verdict);
  Judge({{limits.spread, fit->spread}}, &joint.verdict);
  joint.center = axis.point;
  joint.parent_axes =
      AxesAlong(2, axis.direction, 1, MiddleOf(humerus) - axis.point);
  joint.child_axes = joint.parent_axes;
  return joint;
}

FoundJoint FindForearm(const Limb& limb) {
  FoundJoint joint = StartedJoint(JointKind::kForearm, limb);
  const SurfacePoints& humerus = Needed(limb, BoneKind::kHumerus);
  const SurfacePoints& ulna = Needed(limb, BoneKind::kUlna);
  const SurfacePoints& radius = Needed(limb, BoneKind::kRadius);
  const SurfacePoints fovea = FacingSurface(radius, humerus);
  const auto facing = static_cast<double>(fovea.size());
  if (Judge({{kJointLimits.forearm.not_facing, facing}}, &joint.verdict) ==
      JointQuality::kFailed) {
    return joint;
  }
  const Eigen::Vector3d elbow = MiddleOf(fovea);
  const Eigen::Vector3d wrist = FarEndOf(ulna, elbow);
  const Axis axis = {(elbow + wrist) / 2, (elbow - wrist).normalized()};
  joint.shapes.push_back(
      AxisShape("head of the ulna to head of the radius", axis));
  joint.shapes.back().is_on_parent = true;
  joint.center = axis.point;
  const std::optional<Eigen::Vector3d> right = RightAtElbow(limb);
  joint.parent_axes = AxesAlong(1, axis.direction, 2, *right);
  joint.child_axes = joint.parent_axes;
  return joint;
}

}  // namespace musclewarp
