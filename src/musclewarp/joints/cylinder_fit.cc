// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/cylinder_fit.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/robust_fit.h"

namespace musclewarp {
namespace {

// A cylinder near the z axis of its own frame. The axis passes (x, y, 0) in the
// direction (u, v, 1); the fifth parameter is the radius.
struct CylinderModel {
  static constexpr int kParameters = 5;
  double scale;

  template <typename T>
  T operator()(const T* p, const double* point) const {
    using std::sqrt;
    const T x = T(point[0]) - p[0], y = T(point[1]) - p[1], z = T(point[2]);
    // |way x direction| / |direction|
    const T cx = y - z * p[3], cy = z * p[2] - x, cz = x * p[3] - y * p[2];
    const T length = sqrt(T(1) + p[2] * p[2] + p[3] * p[3]);
    const T distance = sqrt(cx * cx + cy * cy + cz * cz) / length;
    return RobustResidual<T>(distance - p[4], scale);
  }
};

// Returns a rotation that turns the direction to z.
Eigen::Matrix3d TurnToZ(const Eigen::Vector3d& direction) {
  return Eigen::Quaterniond::FromTwoVectors(direction, Eigen::Vector3d::UnitZ())
      .toRotationMatrix();
}

}  // namespace

Eigen::Vector3d OffsetFrom(const Axis& axis, const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = point - axis.point;
  return way - way.dot(axis.direction) * axis.direction;
}

Cylinder FitCylinder(const Points& points,
                     const Eigen::VectorXd& weights,
                     const Cylinder& start,
                     double scale) {
  CHECK_GE(points.rows(), 5);
  CHECK_EQ(points.rows(), weights.size());
  const Eigen::Matrix3d local_from_world = TurnToZ(start.axis.direction);
  const Points local = (points.rowwise() - start.axis.point.transpose()) *
                       local_from_world.transpose();
  Eigen::Matrix<double, 5, 1> fitted = Eigen::Matrix<double, 5, 1>::Zero();
  fitted[4] = start.radius;
  fitted = FitToPoints(CylinderModel{scale}, local, weights, fitted);
  Cylinder cylinder;
  cylinder.axis.direction =
      local_from_world.transpose() *
      Eigen::Vector3d(fitted[2], fitted[3], 1).normalized();
  const Axis through = {
      start.axis.point + local_from_world.transpose() *
                             Eigen::Vector3d(fitted[0], fitted[1], 0),
      cylinder.axis.direction};
  cylinder.axis.point =
      start.axis.point - OffsetFrom(through, start.axis.point);
  cylinder.radius = std::abs(fitted[4]);
  return cylinder;
}

SurfacePoints PointsOn(const SurfacePoints& surface,
                       const Cylinder& cylinder,
                       double tolerance) {
  return Filtered(surface, [&](int row) {
    const Eigen::Vector3d offset =
        OffsetFrom(cylinder.axis, surface.points.row(row).transpose());
    const double distance = offset.norm();
    return std::abs(distance - cylinder.radius) <= tolerance &&
           surface.normals.row(row).dot(offset) >=
               kJointSearch.fit.least_normal * distance;
  });
}

double AngleCovered(const Points& points, const Axis& axis) {
  constexpr int kSectors = 72;      // of 5 degrees
  constexpr int kFewestPoints = 2;  // a single one may be off the surface
  const Eigen::Matrix3d local_from_world = TurnToZ(axis.direction);
  std::array<int, kSectors> counts = {};
  for (int i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d local =
        local_from_world * (points.row(i).transpose() - axis.point);
    const double turn = std::atan2(local.y(), local.x()) / (2 * M_PI) + 0.5;
    ++counts[std::min(static_cast<int>(turn * kSectors), kSectors - 1)];
  }
  int covered = 0;
  for (const int count : counts) covered += count >= kFewestPoints;
  return covered * 2 * M_PI / kSectors;
}

double SpreadAbout(const Cylinder& cylinder, const Points& points) {
  if (points.rows() == 0) return 0;
  double sum = 0;
  for (int i = 0; i < points.rows(); ++i) {
    const double distance =
        OffsetFrom(cylinder.axis, points.row(i).transpose()).norm();
    sum += (distance - cylinder.radius) * (distance - cylinder.radius);
  }
  return std::sqrt(sum / points.rows());
}

}  // namespace musclewarp
