// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/ankle_joints.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <optional>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/ankle.h"
#include "musclewarp/joints/joint_building.h"

namespace musclewarp {
namespace {

// Forward and up at the ankle, as the bones of the foot have it.
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

// The bone that carries the tibia: the talus, or the foot in one mesh.
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

// The middle of the tips of both malleoli: of the lowest points of tibia and
// fibula on either side. None without a fibula, whose tip is the lower one.
std::optional<Eigen::Vector3d> MiddleOfTips(const Limb& limb,
                                            const FootDirections& foot,
                                            const Eigen::Vector3d& middle) {
  constexpr double kHighest = 5;  // mm, of the outer tip above the inner one
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
  if (inner_height == kNone || outer_height > inner_height + kHighest) {
    return std::nullopt;
  }
  return (inner + outer) / 2;
}

// Signs that the dome does not tell the height of the axis; it is then that of
// the tips of the malleoli.
void JudgeAnkle(const Limb& limb,
                const FemurShape& femur,
                const FootDirections& foot,
                AnkleFit* fit,
                JointVerdict* verdict) {
  constexpr double kLeastAngle = RadiansOf(60);
  constexpr double kLargestSpread = 0.5;   // mm
  constexpr double kLargestRadius = 1.25;  // by that of the head
  constexpr double kLargestHeight = 0.25;  // by that of the head
  const double radius = kLargestRadius * femur.HeadRadius();
  const double height = kLargestHeight * femur.HeadRadius();
  const std::optional<Eigen::Vector3d> tips =
      MiddleOfTips(limb, foot, fit->cylinder.axis.point);
  const double above =
      tips ? (*tips - fit->cylinder.axis.point).dot(foot.up) : 0;
  if (fit->angle >= kLeastAngle && fit->cylinder.radius <= radius &&
      fit->spread <= kLargestSpread && std::abs(above) <= height) {
    return;
  }
  verdict->Weaken("the dome of the talus covers " + DegreesText(fit->angle) +
                  " of a cylinder of " + RoundedText(fit->cylinder.radius, 1) +
                  " mm, is off it by " + RoundedText(fit->spread, 2) +
                  " mm, and the tips of the malleoli are " +
                  RoundedText(std::abs(above), 1) +
                  " mm above or below its axis; 60 degrees or more, " +
                  RoundedText(radius, 1) + ", " +
                  RoundedText(kLargestSpread, 1) + " and " +
                  RoundedText(height, 1) +
                  " mm or less are expected: a dome flattened by thick slices" +
                  (tips ? ". The height of the axis is that of the tips" : ""));
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
    joint.verdict.Fail(
        "no part of the talus looks at the tibia within 6 mm: "
        "bones from two scans, or of two legs");
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
    joint.verdict.Fail(
        "no spheres fit the head of the talus and its facet above the heel "
        "bone: the navicular or the heel bone is not there, or a bone is of "
        "another scan");
    return joint;
  }
  const FootDirections foot =
      DirectionsOfFoot(limb, *limb.Find(BoneKind::kTalus), fit, femur);
  joint.center = fit->axis.point;
  joint.shapes.push_back(ShapeOf("head of the talus", fit->head));
  joint.shapes.push_back(ShapeOf("facet above the heel bone", fit->facet));
  for (FittedShape& shape : joint.shapes) shape.is_on_parent = true;
  constexpr double kLeastFacet = 250;     // mm^2
  constexpr double kLeastDistance = 1.4;  // by the radius of the head
  if (fit->facet_area < kLeastFacet) {
    joint.verdict.Weaken(
        "only " + RoundedText(fit->facet_area, 0) +
        " mm2 of the talus look at the heel bone as a hollow sphere, " +
        RoundedText(kLeastFacet, 0) +
        " mm2 or more are expected: bones too far apart, or a coarse mesh");
  }
  // The angle of the axis is uncertain by that of a centre over the distance
  // between both.
  const double distance =
      (fit->head.sphere.center - fit->facet.sphere.center).norm();
  const double least = kLeastDistance * femur.HeadRadius();
  if (distance < least) {
    joint.verdict.Weaken("the centres of both spheres are only " +
                         RoundedText(distance, 0) + " mm apart, " +
                         RoundedText(least, 0) + " mm or more are expected");
  }
  joint.parent_axes = AxesAlong(0, fit->axis.direction, 1, foot.up);
  joint.child_axes = joint.parent_axes;
  return joint;
}

}  // namespace musclewarp
