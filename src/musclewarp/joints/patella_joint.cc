// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/patella_joint.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/joint_building.h"
#include "musclewarp/joints/joint_limits.h"
#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/robust_fit.h"

namespace musclewarp {
namespace {

// Places in the plane across the axis of the knee: x forward, y up, mm.
using Place = Eigen::Vector2d;

// The plane of a knee, with its axis at the origin.
struct KneePlane {
  Eigen::Vector3d center;
  Eigen::Matrix3d axes;  // of the femur: forward, up, right

  Eigen::Vector3d Local(const Eigen::Vector3d& point) const {
    return axes.transpose() * (point - center);
  }
  Place InPlane(const Eigen::Vector3d& point) const {
    return Local(point).head<2>();
  }
};

struct Circle {
  Place center = Place::Zero();
  double radius = 0;
  double spread = 0;  // mm
  double angle = 0;   // covered, rad
};

struct CircleModel {
  static constexpr int kParameters = 3;
  double scale;

  template <typename T>
  T operator()(const T* circle, const double* point) const {
    using std::sqrt;
    const T x = T(point[0]) - circle[0], y = T(point[1]) - circle[1];
    return RobustResidual<T>(sqrt(x * x + y * y) - circle[2], scale);
  }
};

// The groove of the femur as seen along the axis: the surface before and below
// the axis in a strip beside the middle of the patella.
Points GrooveIn(const SurfacePoints& femur,
                const KneePlane& plane,
                const Eigen::Vector3d& patella) {
  const PatellaSearch& search = kJointSearch.patella;
  const double middle = plane.Local(patella).z();
  Points groove(femur.size(), 3);
  int count = 0;
  for (int i = 0; i < femur.size(); ++i) {
    const Eigen::Vector3d point = plane.Local(femur.points.row(i).transpose());
    const Eigen::Vector3d normal =
        plane.axes.transpose() * femur.normals.row(i).transpose();
    const bool is_before = point.x() > 0 && normal.x() > search.groove_forward;
    const bool is_low =
        point.y() > -search.groove_below && point.y() < search.groove_above;
    if (!is_before || !is_low ||
        std::abs(point.z() - middle) > search.half_strip ||
        std::abs(normal.z()) > search.groove_slant) {
      continue;
    }
    groove.row(count++) = Eigen::RowVector3d(point.x(), point.y(), 0);
  }
  groove.conservativeResize(count, 3);
  return groove;
}

std::optional<Circle> FitCircle(const Points& points) {
  if (points.rows() < kJointSearch.patella.groove_points) return std::nullopt;
  const Eigen::Vector3d fitted =
      FitToPoints(CircleModel{kJointSearch.fit.loss_scale},
                  points,
                  Eigen::VectorXd::Ones(points.rows()),
                  Eigen::Vector3d(0, 0, kJointSearch.patella.groove_radius));
  Circle circle = {fitted.head<2>(), std::abs(fitted[2]), 0, 0};
  const Eigen::ArrayXd off =
      (points.leftCols<2>().rowwise() - circle.center.transpose())
          .rowwise()
          .norm()
          .array() -
      circle.radius;
  const Axis axis = {{circle.center.x(), circle.center.y(), 0},
                     Eigen::Vector3d::UnitZ()};
  circle.angle = AngleCovered(points, axis);
  circle.spread = std::sqrt(off.square().mean());
  return circle;
}

// Returns the tuberosity: the foremost point of the tibia below the joint.
std::optional<Eigen::Vector3d> TuberosityOf(const SurfacePoints& tibia,
                                            const KneePlane& plane) {
  const PatellaSearch& search = kJointSearch.patella;
  std::optional<Eigen::Vector3d> farthest;
  for (int i = 0; i < tibia.size(); ++i) {
    const Eigen::Vector3d point = tibia.points.row(i).transpose();
    const Eigen::Vector3d local = plane.Local(point);
    if (-local.y() < search.tuberosity_from ||
        -local.y() > search.tuberosity_to) {
      continue;
    }
    if (farthest && local.x() <= plane.Local(*farthest).x()) continue;
    farthest = point;
  }
  return farthest;
}

Eigen::Vector3d LowestOf(const SurfacePoints& bone, const KneePlane& plane) {
  int lowest = 0;
  (bone.points * plane.axes.col(1)).minCoeff(&lowest);
  return bone.points.row(lowest).transpose();
}

// Turns a place about a centre as flexion does: backwards at the lower end.
Place Flexed(const Place& place, const Place& center, double angle) {
  return center + Eigen::Rotation2Dd(-angle) * (place - center);
}

// Follows the angle of the patella while the knee turns away from the scan, as
// long as the ligament allows it.
void FollowKnee(const Circle& groove,
                const Place& tip,
                const Place& tuberosity,
                double scan,
                double step,
                double last,
                std::vector<std::pair<double, double>>* path) {
  constexpr int kIterations = 30;  // of Newton's method
  const double length = (tip - tuberosity).norm();
  double angle = 0;
  for (double knee = scan + step; (last - knee) * step >= 0; knee += step) {
    const Place end = Flexed(tuberosity, Place::Zero(), knee - scan);
    const auto stretch = [&](double at) {
      return (Flexed(tip, groove.center, at) - end).norm() - length;
    };
    for (int i = 0; i < kIterations; ++i) {
      constexpr double kBeside = 1e-6;  // rad, for the slope by differences
      constexpr double kLargest = 0.1;  // rad: the knee turns by 0.09 a step
      const double slope =
          (stretch(angle + kBeside) - stretch(angle - kBeside)) / (2 * kBeside);
      if (std::abs(slope) < 1) return;  // mm by rad: the ligament is in line
      angle -= std::clamp(stretch(angle) / slope, -kLargest, kLargest);
    }
    if (std::abs(stretch(angle)) > 1e-6) return;  // mm: it did not converge
    path->emplace_back(knee, angle);
  }
}

// Couples the coordinate of the patella to that of the knee, over slightly more
// than its range.
void CoupleToKnee(const FoundJoint& knee,
                  const Circle& groove,
                  const Place& tip,
                  const Place& tuberosity,
                  FoundJoint* patella) {
  constexpr double kStep = RadiansOf(kJointSearch.patella.knee_step);
  constexpr double kBeyond = RadiansOf(kJointSearch.patella.beyond_range);
  const JointCoordinate of_knee = CoordinatesOf(knee.kind, knee.side)[0];
  const double scan = ScanCoordinates(knee)[0];
  const double low = of_knee.lowest * kRadiansPerDegree - kBeyond;
  const double high = of_knee.highest * kRadiansPerDegree + kBeyond;
  std::vector<std::pair<double, double>> path = {{scan, 0}};
  FollowKnee(groove, tip, tuberosity, scan, kStep, high, &path);
  const double reached = path.back().first;
  FollowKnee(groove, tip, tuberosity, scan, -kStep, low, &path);
  std::sort(path.begin(), path.end());
  Judge(
      {{kJointLimits.patella.held_back, of_knee.highest - DegreesOf(reached)}},
      &patella->verdict,
      {{"reached", DegreesText(reached)}});
  patella->coupling.coordinate = of_knee.name;
  for (const auto& [at, value] : path) {
    patella->coupling.at.push_back(at);
    patella->coupling.values.push_back(value);
  }
}

}  // namespace

FoundJoint FindPatella(const Limb& limb, const FoundJoint& knee) {
  const PatellaLimits& limits = kJointLimits.patella;
  FoundJoint joint = StartedJoint(JointKind::kPatella, limb);
  const SurfacePoints* femur = limb.Find(BoneKind::kFemur);
  const SurfacePoints* tibia = limb.Find(BoneKind::kTibia);
  const SurfacePoints* patella = limb.Find(BoneKind::kPatella);
  CHECK(femur != nullptr && tibia != nullptr && patella != nullptr);
  if (!knee.IsFound()) {
    Judge({{limits.no_knee}}, &joint.verdict);
    return joint;
  }
  const KneePlane plane = {knee.center, knee.parent_axes};
  const Eigen::Vector3d middle = patella->points.colwise().mean().transpose();
  const std::optional<Circle> groove =
      FitCircle(GrooveIn(*femur, plane, middle));
  const std::optional<Eigen::Vector3d> tuberosity = TuberosityOf(*tibia, plane);
  if (!groove || !tuberosity || plane.Local(middle).x() <= 0) {
    Judge({{limits.no_groove}}, &joint.verdict);
    return joint;
  }
  joint.center =
      plane.center + plane.axes * Eigen::Vector3d(groove->center.x(),
                                                  groove->center.y(),
                                                  plane.Local(middle).z());
  joint.parent_axes = plane.axes;
  joint.child_axes = plane.axes;
  joint.shapes.push_back(
      ShapeOf("groove of the femur",
              {{joint.center, plane.axes.col(2)}, groove->radius},
              groove->spread,
              groove->angle));
  joint.shapes.back().is_on_parent = true;
  Judge({{limits.spread, groove->spread}}, &joint.verdict);
  CoupleToKnee(knee,
               *groove,
               plane.InPlane(LowestOf(*patella, plane)),
               plane.InPlane(*tuberosity),
               &joint);
  return joint;
}

}  // namespace musclewarp
