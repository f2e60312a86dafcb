// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/ankle_joints.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>

#include "musclewarp/base/angles.h"
#include "musclewarp/joints/ankle.h"
#include "musclewarp/joints/joint_building.h"
#include "musclewarp/joints/joint_limits.h"
#include "musclewarp/joints/joint_search.h"

namespace musclewarp {
namespace {

// The directions forward and up at an ankle, by the bones of the foot.
struct FootDirections {
  Eigen::Vector3d forward, up;
};
FootDirections DirectionsOfFoot(const Limb& limb,
                                const SurfacePoints& talus,
                                const std::optional<SubtalarFit>& subtalar,
                                const FemurShape& femur) {
  const SurfacePoints& tibia = *limb.Find(BoneKind::kTibia);
  const Eigen::Vector3d middle = talus.points.colwise().mean().transpose();
  FootDirections directions;
  directions.up =
      (tibia.points.colwise().mean().transpose() - middle).normalized();
  if (subtalar) {
    directions.forward =
        subtalar->head.sphere.center - subtalar->facet.sphere.center;
  } else if (femur.directions) {
    directions.forward = -femur.directions->back;
  } else if (const SurfacePoints* foot = limb.Find(BoneKind::kFoot)) {
    int farthest = 0;
    const Eigen::VectorXd distance =
        (foot->points.rowwise() - middle.transpose()).rowwise().norm();
    distance.maxCoeff(&farthest);
    directions.forward = foot->points.row(farthest).transpose() - middle;
  } else if (limb.image_axes) {
    directions.forward = limb.image_axes->col(0);
  } else {
    directions.forward = directions.up.unitOrthogonal();
  }
  directions.forward -= directions.forward.dot(directions.up) * directions.up;
  directions.forward.normalize();
  return directions;
}

// Returns the bone below the tibia: the talus, or a foot in one mesh.
const SurfacePoints& TalusOf(const Limb& limb) {
  const SurfacePoints* talus = limb.Find(BoneKind::kTalus);
  if (talus == nullptr) talus = limb.Find(BoneKind::kFoot);
  CHECK(talus != nullptr);
  return *talus;
}

std::optional<SubtalarFit> SubtalarOf(const Limb& limb) {
  const SurfacePoints* talus = limb.Find(BoneKind::kTalus);
  const SurfacePoints* foot = limb.Find(BoneKind::kFoot);
  if (talus == nullptr || foot == nullptr) return std::nullopt;
  return FitSubtalar(*talus, *foot);
}

// Returns the middle between the tips of both malleoli, the lowest points of
// tibia and fibula on either side; none without a fibula, which has the lower
// tip.
std::optional<Eigen::Vector3d> MiddleOfTips(const Limb& limb,
                                            const FootDirections& foot,
                                            const Eigen::Vector3d& middle) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d right = foot.forward.cross(foot.up);
  const Eigen::Vector3d outward =
      limb.side == Side::kRight ? right : Eigen::Vector3d(-right);
  Eigen::Vector3d inner, outer;
  double inner_height = kNone, outer_height = kNone;
  for (const BoneKind kind : {BoneKind::kTibia, BoneKind::kFibula}) {
    const SurfacePoints* bone = limb.Find(kind);
    if (bone == nullptr) continue;
    for (int i = 0; i < bone->size(); ++i) {
      const Eigen::Vector3d point = bone->points.row(i).transpose();
      const double height = (point - middle).dot(foot.up);
      const bool is_outer = (point - middle).dot(outward) > 0;
      double* lowest = is_outer ? &outer_height : &inner_height;
      if (height >= *lowest) continue;
      *lowest = height;
      (is_outer ? outer : inner) = point;
    }
  }
  if (inner_height == kNone ||
      outer_height > inner_height + kJointSearch.talus.highest_outer_tip) {
    return std::nullopt;
  }
  return (inner + outer) / 2;
}

// Judges the fit of the dome. Where it is weak, the axis is moved to the height
// of the tips of the malleoli.
void JudgeAnkle(const Limb& limb,
                const FemurShape& femur,
                const FootDirections& foot,
                AnkleFit* fit,
                JointVerdict* verdict) {
  const AnkleLimits& limits = kJointLimits.ankle;
  const std::optional<Eigen::Vector3d> tips =
      MiddleOfTips(limb, foot, fit->cylinder.axis.point);
  const double above =
      tips ? (*tips - fit->cylinder.axis.point).dot(foot.up) : 0;
  const double head = femur.HeadRadius();
  const JointQuality quality = Judge(
      {{limits.angle, DegreesOf(fit->angle)},
       {limits.radius, fit->cylinder.radius, head},
       {limits.spread, fit->spread},
       {limits.height, std::abs(above), head}},
      verdict,
      {{"height", tips ? ". The height of the axis is that of the tips" : ""}});
  if (quality == JointQuality::kGood) return;
  fit->cylinder.axis.point += above * foot.up;
}

}  // namespace

FoundJoint FindAnkle(const Limb& limb, const FemurShape& femur) {
  FoundJoint joint = StartedJoint(JointKind::kAnkle, limb);
  const SurfacePoints& talus = TalusOf(limb);
  const SurfacePoints* tibia = limb.Find(BoneKind::kTibia);
  CHECK(tibia != nullptr);
  std::optional<AnkleFit> fit = FitAnkle(talus, *tibia);
  if (!fit) {
    Judge({{kJointLimits.ankle.not_facing}}, &joint.verdict);
    return joint;
  }
  const FootDirections foot =
      DirectionsOfFoot(limb, talus, SubtalarOf(limb), femur);
  JudgeAnkle(limb, femur, foot, &*fit, &joint.verdict);
  Eigen::Vector3d right = fit->cylinder.axis.direction;
  if (right.dot(foot.forward.cross(foot.up)) < 0) right = -right;
  fit->cylinder.axis.direction = right;
  joint.center = fit->cylinder.axis.point;
  joint.parent_axes = AxesAlong(2, right, 1, foot.up);
  joint.child_axes = joint.parent_axes;
  joint.shapes.push_back(
      ShapeOf("dome of the talus", fit->cylinder, fit->spread, fit->angle));
  return joint;
}

FoundJoint FindSubtalar(const Limb& limb, const FemurShape& femur) {
  FoundJoint joint = StartedJoint(JointKind::kSubtalar, limb);
  CHECK(limb.Find(BoneKind::kTalus) != nullptr);
  const std::optional<SubtalarFit> fit = SubtalarOf(limb);
  if (!fit) {
    Judge({{kJointLimits.subtalar.no_spheres}}, &joint.verdict);
    return joint;
  }
  const FootDirections foot =
      DirectionsOfFoot(limb, *limb.Find(BoneKind::kTalus), fit, femur);
  joint.center = fit->axis.point;
  joint.shapes.push_back(ShapeOf("head of the talus", fit->head));
  joint.shapes.push_back(ShapeOf("facet above the heel bone", fit->facet));
  for (FittedShape& shape : joint.shapes) shape.is_on_parent = true;
  Judge({{kJointLimits.subtalar.facet, fit->facet_area}}, &joint.verdict);
  const double distance =
      (fit->head.sphere.center - fit->facet.sphere.center).norm();
  Judge({{kJointLimits.subtalar.distance, distance, femur.HeadRadius()}},
        &joint.verdict);
  joint.parent_axes = AxesAlong(0, fit->axis.direction, 1, foot.up);
  joint.child_axes = joint.parent_axes;
  return joint;
}

}  // namespace musclewarp
