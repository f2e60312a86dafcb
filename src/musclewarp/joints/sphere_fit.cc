// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/sphere_fit.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/robust_fit.h"
#include "musclewarp/joints/vote_peaks.h"

namespace musclewarp {
namespace {

struct SphereModel {
  static constexpr int kParameters = 4;  // centre, radius
  double scale;

  template <typename T>
  T operator()(const T* sphere, const double* point) const {
    using std::sqrt;
    T squared(0);
    for (int axis = 0; axis < 3; ++axis) {
      const T way = T(point[axis]) - sphere[axis];
      squared += way * way;
    }
    return RobustResidual<T>(sqrt(squared) - sphere[3], scale);
  }
};

Points VotesFor(const SurfacePoints& surface, double radius, bool is_hollow) {
  return surface.points + (is_hollow ? radius : -radius) * surface.normals;
}

// The points near a sphere whose normals lie along its radii.
SurfacePoints PointsOn(const SurfacePoints& surface,
                       const Sphere& sphere,
                       double tolerance,
                       bool is_hollow) {
  const double sign = is_hollow ? -1 : 1;
  return Filtered(surface, [&](int row) {
    const Eigen::Vector3d way =
        surface.points.row(row).transpose() - sphere.center;
    const double distance = way.norm();
    return std::abs(distance - sphere.radius) <= tolerance &&
           sign * surface.normals.row(row).dot(way) >=
               kJointSearch.fit.least_normal * distance;
  });
}

// Fits a sphere to the points near it, which are selected again after each fit.
std::optional<SphereFit> Refined(const SurfacePoints& surface,
                                 Sphere sphere,
                                 const SphereSearch& search) {
  constexpr int kRounds = kJointSearch.fit.fit_rounds;
  SphereFit fit;
  for (int round = 0; round < kRounds; ++round) {
    const double tolerance =
        std::max(kJointSearch.fit.sphere_reach,
                 kJointSearch.fit.vote_tolerance * sphere.radius / (1 + round));
    const SurfacePoints near =
        PointsOn(surface, sphere, tolerance, search.is_hollow);
    if (near.size() < kJointSearch.fit.fewest_points) return std::nullopt;
    sphere = FitSphere(near.points, sphere, kJointSearch.fit.loss_scale);
    fit.points = near.size();
    fit.spread = std::sqrt(
        ((near.points.rowwise() - sphere.center.transpose()).rowwise().norm() -
         Eigen::VectorXd::Constant(near.size(), sphere.radius))
            .squaredNorm() /
        near.size());
    if (!(sphere.radius >= search.min_radius &&
          sphere.radius <= search.max_radius)) {
      return std::nullopt;
    }
  }
  fit.sphere = sphere;
  const Points votes = VotesFor(surface, sphere.radius, search.is_hollow);
  const int count =
      ((votes.rowwise() - sphere.center.transpose()).rowwise().norm().array() <=
       kJointSearch.fit.vote_tolerance * sphere.radius)
          .count();
  fit.coverage =
      count * surface.area / (4 * M_PI * sphere.radius * sphere.radius);
  return fit;
}

}  // namespace

Sphere FitSphere(const Points& points, const Sphere& start, double scale) {
  CHECK_GE(points.rows(), 4);
  // About the start, so that the result does not depend on where the origin is.
  const Points local = points.rowwise() - start.center.transpose();
  const Eigen::Vector4d fitted =
      FitToPoints(SphereModel{scale},
                  local,
                  Eigen::VectorXd::Ones(points.rows()),
                  Eigen::Vector4d(0, 0, 0, start.radius));
  return {start.center + fitted.head<3>(), fitted[3]};
}

std::optional<SphereFit> FindSphere(const SurfacePoints& surface,
                                    const SphereSearch& search) {
  constexpr int kPeaksPerRadius = kJointSearch.fit.peaks_of_sphere;
  std::vector<double> radii;
  for (double r = search.min_radius; r <= search.max_radius;
       r += kJointSearch.fit.radius_step) {
    radii.push_back(r);
  }
  std::vector<std::optional<SphereFit>> best_of_radius(radii.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < radii.size(); ++i) {
    const Points votes = VotesFor(surface, radii[i], search.is_hollow);
    for (const VotePeak& peak :
         FindVotePeaks(votes,
                       kJointSearch.fit.vote_tolerance * radii[i],
                       kPeaksPerRadius)) {
      const auto fit = Refined(surface, {peak.place, radii[i]}, search);
      std::optional<SphereFit>& best = best_of_radius[i];
      if (fit && (!best || fit->coverage > best->coverage)) best = fit;
    }
  }
  std::optional<SphereFit> best;
  for (const auto& fit : best_of_radius) {
    if (fit && (!best || fit->coverage > best->coverage)) best = fit;
  }
  return best;
}

}  // namespace musclewarp
