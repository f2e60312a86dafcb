// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/ankle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/joints/facing_surface.h"
#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/robust_fit.h"

namespace musclewarp {
namespace {

SurfacePoints AcrossAxis(const SurfacePoints& surface, const Axis& axis) {
  return Filtered(surface, [&](int row) {
    return std::abs(surface.normals.row(row).dot(axis.direction)) <=
           kJointSearch.talus.dome_slant;
  });
}

// Returns cylinders to start from. Their axes lie one radius below the middle
// of the dome, in several directions at right angles to its mean normal.
std::vector<Cylinder> StartsFor(const SurfacePoints& dome,
                                const Eigen::Vector3d& up) {
  constexpr int kDirections = kJointSearch.talus.dome_directions;
  const Eigen::Vector3d middle = dome.points.colwise().mean().transpose();
  const Eigen::Vector3d first = up.unitOrthogonal();
  const Eigen::Vector3d second = up.cross(first);
  std::vector<Cylinder> starts;
  // From a small dome to a flattened one, mm.
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

// Fits a cylinder to the points near it.
std::optional<AnkleFit> Refined(const SurfacePoints& dome, Cylinder cylinder) {
  constexpr int kRounds = kJointSearch.fit.fit_rounds;
  SurfacePoints near;
  for (int round = 0; round < kRounds; ++round) {
    const double tolerance =
        std::max(kJointSearch.fit.sphere_reach,
                 kJointSearch.talus.dome_first_reach / (1 + round));
    near = PointsOn(AcrossAxis(dome, cylinder.axis), cylinder, tolerance);
    if (near.size() < kJointSearch.fit.fewest_points) return std::nullopt;
    cylinder = FitCylinder(near.points,
                           Eigen::VectorXd::Ones(near.size()),
                           cylinder,
                           kJointSearch.fit.loss_scale);
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

// Returns the whole dome of a talus: the part that faces the tibia, and its
// continuation before and behind it.
SurfacePoints WholeDome(const SurfacePoints& talus,
                        const SurfacePoints& dome,
                        const Cylinder& cylinder,
                        const Eigen::Vector3d& up) {
  const SurfacePoints near =
      PointsOn(dome, cylinder, kJointSearch.fit.sphere_reach);
  const Eigen::VectorXd along = near.points * cylinder.axis.direction;
  const double low = along.minCoeff(), high = along.maxCoeff();
  return Filtered(talus, [&](int row) {
    const Eigen::Vector3d point = talus.points.row(row).transpose();
    const double place = point.dot(cylinder.axis.direction);
    const Eigen::Vector3d offset = OffsetFrom(cylinder.axis, point);
    return place >= low && place <= high &&
           offset.dot(up) >= kJointSearch.talus.whole_dome_up * offset.norm();
  });
}

}  // namespace

std::optional<AnkleFit> FitAnkle(const SurfacePoints& talus,
                                 const SurfacePoints& tibia) {
  // The normals of the facets beside the dome are opposite and cancel out.
  const SurfacePoints facing = FacingSurface(talus, tibia);
  if (facing.size() == 0) return std::nullopt;
  const Eigen::Vector3d up =
      facing.normals.colwise().sum().transpose().normalized();
  const SurfacePoints dome = Filtered(facing, [&](int row) {
    return facing.normals.row(row).dot(up) >= kJointSearch.talus.dome_up;
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
  const TalusSearch& search = kJointSearch.talus;
  const SurfacePoints facing = FacingSurface(talus, foot);
  const std::optional<SphereFit> head = FindSphere(
      facing, {search.least_talus_head, search.largest_talus_head, false});
  const std::optional<SphereFit> facet =
      FindSphere(facing, {search.least_facet, search.largest_facet, true});
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
