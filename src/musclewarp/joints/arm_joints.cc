// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/arm_joints.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <optional>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/facing_surface.h"
#include "musclewarp/joints/joint_building.h"
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
  constexpr double kLastPart = 0.04;  // of the distance
  const Eigen::VectorXd distance =
      (bone.points.rowwise() - place.transpose()).rowwise().norm();
  const double farthest = distance.maxCoeff();
  return MiddleOf(Filtered(bone, [&](int row) {
    return distance[row] >= (1 - kLastPart) * farthest;
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
  // The head of a humerus is half a ball; a whole one covers 0.42.
  constexpr double kFailedCoverage = 0.27, kWeakCoverage = 0.35;
  constexpr double kWeakSpread = 0.8;  // mm
  FoundJoint joint = StartedJoint(JointKind::kShoulder, limb);
  const std::optional<SphereFit> head =
      FindSphere(Needed(limb, BoneKind::kHumerus), {});
  const double coverage = head ? head->coverage : 0;
  if (coverage < kFailedCoverage) {
    joint.verdict.Fail(
        "no head on the humerus: the best sphere of 14 to 32 mm covers " +
        RoundedText(100 * coverage, 0) + " % of itself, " +
        RoundedText(100 * kFailedCoverage, 0) +
        " % or more are needed; are the meshes in mm, and is the upper end of "
        "the humerus there");
    return joint;
  }
  joint.center = head->sphere.center;
  joint.shapes.push_back(ShapeOf("head of the humerus", *head));
  if (coverage < kWeakCoverage) {
    joint.verdict.Weaken("the head covers " + RoundedText(100 * coverage, 0) +
                         " % of its sphere, " +
                         RoundedText(100 * kWeakCoverage, 0) +
                         " % or more are expected: it is cut");
  }
  if (head->spread > kWeakSpread) {
    joint.verdict.Weaken("the head is off its sphere by " +
                         RoundedText(head->spread, 1) + " mm, at most " +
                         RoundedText(kWeakSpread, 1) + " mm are expected");
  }
  if (limb.image_axes) {
    joint.parent_axes = *limb.image_axes;
  } else {
    joint.verdict.Weaken(
        "the axes of the image are not known: those of the file are taken for "
        "forward, up and right");
  }
  joint.child_axes = joint.parent_axes;
  return joint;
}

FoundJoint FindElbow(const Limb& limb) {
  constexpr double kFailedAngle = RadiansOf(60), kWeakAngle = RadiansOf(120);
  constexpr double kWeakSpread = 1.5;  // mm
  FoundJoint joint = StartedJoint(JointKind::kElbow, limb);
  const SurfacePoints& humerus = Needed(limb, BoneKind::kHumerus);
  const SurfacePoints facing = ElbowSurface(limb);
  const std::optional<RevolutionFit> fit = FitRevolution(facing);
  const double angle = fit ? AngleCovered(facing.points, fit->axis) : 0;
  if (angle < kFailedAngle) {
    joint.verdict.Fail(
        "the humerus looks at the forearm over " + DegreesText(angle) +
        ", 60 or more are needed: bones from two scans, or of two "
        "arms");
    return joint;
  }
  Axis axis = fit->axis;
  const std::optional<Eigen::Vector3d> right = RightAtElbow(limb);
  if (right && axis.direction.dot(*right) < 0) axis.direction *= -1;
  if (!right) {
    joint.verdict.Weaken(
        "neither a radius nor the image tells where the right is: flexion may "
        "go backwards");
  }
  joint.shapes.push_back(AxisShape("trochlea and capitulum", axis));
  joint.shapes.back().spread = fit->spread;
  joint.shapes.back().angle = angle;
  joint.shapes.back().is_on_parent = true;
  if (angle < kWeakAngle) {
    joint.verdict.Weaken("the humerus looks at the forearm over " +
                         DegreesText(angle) + ", 120 or more are expected");
  }
  if (fit->spread > kWeakSpread) {
    joint.verdict.Weaken(
        "normals pass the axis by " + RoundedText(fit->spread, 1) + " mm, " +
        RoundedText(kWeakSpread, 1) + " mm or less is expected");
  }
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
  if (fovea.size() < 10) {
    joint.verdict.Fail(
        "the head of the radius does not look at the humerus within 6 mm: "
        "bones from two scans, or cut");
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
