// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/ankle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/joints/facing_surface.h"
#include "musclewarp/joints/robust_fit.h"

namespace musclewarp {
namespace {

SurfacePoints AcrossAxis(const SurfacePoints& surface, const Axis& axis) {
  constexpr double kLargestSlant = 0.4;  // of normals along the axis
  return Filtered(surface, [&](int row) {
    return std::abs(surface.normals.row(row).dot(axis.direction)) <=
           kLargestSlant;
  });
}

// Cylinders to start from: their axes in several directions at right angles to
// where the dome looks, as far below it as its radius may be.
std::vector<Cylinder> StartsFor(const SurfacePoints& dome,
                                const Eigen::Vector3d& up) {
  constexpr int kDirections = 12;  // in half a turn
  const Eigen::Vector3d middle = dome.points.colwise().mean().transpose();
  const Eigen::Vector3d first = up.unitOrthogonal();
  const Eigen::Vector3d second = up.cross(first);
  std::vector<Cylinder> starts;
  for (const double radius : {14.0, 20.0, 28.0}) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = M_PI * i / kDirections;
      starts.push_back({{middle - radius * up,
                         std::cos(angle) * first + std::sin(angle) * second},
                        radius});
    }
  }
  return starts;
}

// Fits a cylinder to what lies near it.
std::optional<AnkleFit> Refined(const SurfacePoints& dome, Cylinder cylinder) {
  constexpr int kRounds = 6;
  constexpr int kFewestPoints = 30;
  SurfacePoints near;
  for (int round = 0; round < kRounds; ++round) {
    const double tolerance = std::max(1.5, 6.0 / (1 + round));
    near = PointsOn(AcrossAxis(dome, cylinder.axis), cylinder, tolerance);
    if (near.size() < kFewestPoints) return std::nullopt;
    cylinder = FitCylinder(
        near.points, Eigen::VectorXd::Ones(near.size()), cylinder, kLossScale);
  }
  AnkleFit fit;
  fit.cylinder = cylinder;
  fit.points = near.size();
  fit.angle = AngleCovered(near.points, cylinder.axis);
  fit.spread = SpreadAbout(cylinder, near.points);
  const Eigen::Vector3d middle = near.points.colwise().mean().transpose();
  fit.cylinder.axis.point = middle - OffsetFrom(cylinder.axis, middle);
  return fit;
}

// The points of a talus that go on from those of its dome which look at the
// tibia, before and behind them.
SurfacePoints WholeDome(const SurfacePoints& talus,
                        const SurfacePoints& dome,
                        const Cylinder& cylinder,
                        const Eigen::Vector3d& up) {
  // The dome of a talus ends 75 degrees before and behind its top.
  constexpr double kLeastUp = 0.26;
  const SurfacePoints near = PointsOn(dome, cylinder, 1.5);
  const Eigen::VectorXd along = near.points * cylinder.axis.direction;
  const double low = along.minCoeff(), high = along.maxCoeff();
  return Filtered(talus, [&](int row) {
    const Eigen::Vector3d point = talus.points.row(row).transpose();
    const double place = point.dot(cylinder.axis.direction);
    const Eigen::Vector3d offset = OffsetFrom(cylinder.axis, point);
    return place >= low && place <= high &&
           offset.dot(up) >= kLeastUp * offset.norm();
  });
}

}  // namespace

std::optional<AnkleFit> FitAnkle(const SurfacePoints& talus,
                                 const SurfacePoints& tibia) {
  // The facets beside the dome look to opposite sides, which cancels out.
  constexpr double kLeastUp = 0.5;
  const SurfacePoints facing = FacingSurface(talus, tibia);
  if (facing.size() == 0) return std::nullopt;
  const Eigen::Vector3d up =
      facing.normals.colwise().sum().transpose().normalized();
  const SurfacePoints dome = Filtered(facing, [&](int row) {
    return facing.normals.row(row).dot(up) >= kLeastUp;
  });
  if (dome.size() == 0) return std::nullopt;
  std::optional<AnkleFit> best;
  for (const Cylinder& start : StartsFor(dome, up)) {
    const std::optional<AnkleFit> fit = Refined(dome, start);
    if (fit && (!best || fit->points > best->points)) best = fit;
  }
  if (!best) return std::nullopt;
  return Refined(WholeDome(talus, dome, best->cylinder, up), best->cylinder);
}

std::optional<SubtalarFit> FitSubtalar(const SurfacePoints& talus,
                                       const SurfacePoints& foot) {
  const SurfacePoints facing = FacingSurface(talus, foot);
  const std::optional<SphereFit> head =
      FindSphere(facing, {/*min_radius=*/8, /*max_radius=*/30, false});
  const std::optional<SphereFit> facet =
      FindSphere(facing, {/*min_radius=*/10, /*max_radius=*/45, true});
  if (!head || !facet) return std::nullopt;
  SubtalarFit fit;
  fit.head = *head;
  fit.facet = *facet;
  fit.facet_area = facet->points * talus.area;
  const Eigen::Vector3d way = head->sphere.center - facet->sphere.center;
  fit.axis = {(head->sphere.center + facet->sphere.center) / 2,
              way.normalized()};
  return fit;
}

}  // namespace musclewarp
