// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/knee.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/robust_fit.h"
#include "musclewarp/joints/sphere_fit.h"
#include "musclewarp/joints/vote_peaks.h"

namespace musclewarp {
namespace {

constexpr const KneeSearch& kKneeSearch = kJointSearch.knee;

struct Condyles {
  SurfacePoints surface;
  Eigen::Vector3d left;    // of the body
  Eigen::Vector3d middle;  // between both

  bool IsLeft(int row) const {
    return (surface.points.row(row).transpose() - middle).dot(left) > 0;
  }
};

Condyles CondylesOf(const SurfacePoints& femur,
                    const BoneDirections& directions,
                    double head_radius) {
  const Eigen::VectorXd height = femur.points * directions.up;
  const double top =
      directions.lowest + kKneeSearch.condyle_height * head_radius;
  const SurfacePoints end =
      Filtered(femur, [&](int row) { return height[row] <= top; });
  Condyles condyles;
  condyles.left = directions.left;
  condyles.middle.setZero();
  if (end.size() == 0) return condyles;
  const Eigen::VectorXd across = end.points * directions.left;
  condyles.middle = end.points.colwise().mean().transpose();
  condyles.middle += ((across.maxCoeff() + across.minCoeff()) / 2 -
                      condyles.middle.dot(directions.left)) *
                     directions.left;
  condyles.surface = Filtered(end, [&](int row) {
    const Eigen::Vector3d normal = end.normals.row(row).transpose();
    const double angle =
        std::atan2(normal.dot(directions.back), -normal.dot(directions.up));
    return angle >= RadiansOf(kKneeSearch.first_normal) &&
           angle <= RadiansOf(kKneeSearch.last_normal) &&
           std::abs(normal.dot(directions.left)) <= kKneeSearch.condyle_slant;
  });
  return condyles;
}

struct Start {
  Cylinder cylinder;
  double score = 0;
};

// Adds the circles for which both condyles vote in the plane across a
// direction.
void AddStarts(const Condyles& condyles,
               const Eigen::Vector3d& direction,
               double radius,
               std::vector<Start>* starts) {
  const SurfacePoints& surface = condyles.surface;
  const Eigen::Matrix3d flat =
      Eigen::Matrix3d::Identity() - direction * direction.transpose();
  const Points votes =
      (surface.points -
       radius * (surface.normals * flat).rowwise().normalized())
          .rowwise() -
      condyles.middle.transpose();
  const Points in_plane = votes * flat;
  for (const VotePeak& peak :
       FindVotePeaks(in_plane,
                     kJointSearch.fit.vote_tolerance * radius,
                     kJointSearch.fit.peaks_of_circle)) {
    int left = 0, right = 0;
    for (int i = 0; i < surface.size(); ++i) {
      const double distance = (in_plane.row(i).transpose() - peak.place).norm();
      if (distance > kJointSearch.fit.vote_tolerance * radius) continue;
      ++(condyles.IsLeft(i) ? left : right);
    }
    // A larger circle has more surface for the same angle.
    starts->push_back({{{condyles.middle + peak.place, direction}, radius},
                       std::min(left, right) / radius});
  }
}

std::vector<Start> BestStarts(const Condyles& condyles,
                              const BoneDirections& directions,
                              double head_radius) {
  constexpr size_t kStarts = kKneeSearch.starts;
  constexpr double kTilt = RadiansOf(kKneeSearch.start_tilt);
  std::vector<Start> starts;
  for (const auto& [about_up, about_back] :
       {std::pair(0, 0), {-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const Eigen::Vector3d direction =
        Eigen::AngleAxisd(about_up * kTilt, directions.up) *
        (Eigen::AngleAxisd(about_back * kTilt, directions.back) *
         directions.left);
    for (double radius = kKneeSearch.least_condyle * head_radius;
         radius <= kKneeSearch.largest_condyle * head_radius;
         radius += kJointSearch.fit.radius_step) {
      AddStarts(condyles, direction, radius, &starts);
    }
  }
  std::stable_sort(starts.begin(), starts.end(), [](auto& a, auto& b) {
    return a.score > b.score;
  });
  if (starts.size() > kStarts) starts.resize(kStarts);
  return starts;
}

// Returns the points of the left or the right condyle that lie on a cylinder.
SurfacePoints OneOf(const Condyles& condyles,
                    const Cylinder& cylinder,
                    double tolerance,
                    bool is_left) {
  const SurfacePoints side = Filtered(condyles.surface, [&](int row) {
    return condyles.IsLeft(row) == is_left;
  });
  return PointsOn(side, cylinder, tolerance);
}

// Returns the angle between the axis and the line through the centres of
// spheres fitted to both condyles, rad.
double SphereAngle(const SurfacePoints& left,
                   const SurfacePoints& right,
                   const Cylinder& cylinder) {
  Eigen::Vector3d centers[2];
  int next = 0;
  for (const SurfacePoints* condyle : {&left, &right}) {
    const Eigen::Vector3d mean = condyle->points.colwise().mean().transpose();
    const Eigen::Vector3d foot = mean - OffsetFrom(cylinder.axis, mean);
    centers[next++] = FitSphere(condyle->points,
                                {foot, cylinder.radius},
                                kJointSearch.fit.loss_scale)
                          .center;
  }
  const Eigen::Vector3d way = (centers[0] - centers[1]).normalized();
  return std::acos(std::min(1.0, std::abs(way.dot(cylinder.axis.direction))));
}

// Fits a cylinder to the points near it, with the same weight for both
// condyles.
std::optional<KneeFit> Refined(const Condyles& condyles, Cylinder cylinder) {
  constexpr int kRounds = kJointSearch.fit.fit_rounds;
  KneeFit fit;
  for (int round = 0; round < kRounds; ++round) {
    const double tolerance = std::max(
        kKneeSearch.condyle_reach,
        kJointSearch.fit.vote_tolerance * cylinder.radius / (1 + round));
    const SurfacePoints left = OneOf(condyles, cylinder, tolerance, true);
    const SurfacePoints right = OneOf(condyles, cylinder, tolerance, false);
    fit.points = std::min(left.size(), right.size());
    if (fit.points < kJointSearch.fit.fewest_points) return std::nullopt;
    Points both(left.size() + right.size(), 3);
    both << left.points, right.points;
    Eigen::VectorXd weights(both.rows());
    weights << Eigen::VectorXd::Constant(left.size(),
                                         1 / std::sqrt(left.size())),
        Eigen::VectorXd::Constant(right.size(), 1 / std::sqrt(right.size()));
    cylinder =
        FitCylinder(both, weights, cylinder, kJointSearch.fit.loss_scale);
    if (cylinder.axis.direction.dot(condyles.left) < 0) {
      cylinder.axis.direction = -cylinder.axis.direction;
    }
    if (round + 1 < kRounds) continue;
    fit.left_angle = AngleCovered(left.points, cylinder.axis);
    fit.right_angle = AngleCovered(right.points, cylinder.axis);
    fit.spread = SpreadAbout(cylinder, both);
    fit.sphere_angle = SphereAngle(left, right, cylinder);
    const Eigen::Vector3d middle =
        (left.points.colwise().mean() + right.points.colwise().mean())
            .transpose() /
        2;
    cylinder.axis.point = middle - OffsetFrom(cylinder.axis, middle);
  }
  fit.cylinder = cylinder;
  return fit;
}

}  // namespace

std::optional<KneeFit> FitKnee(const SurfacePoints& femur,
                               const BoneDirections& directions,
                               double head_radius) {
  const Condyles condyles = CondylesOf(femur, directions, head_radius);
  const std::vector<Start> starts =
      BestStarts(condyles, directions, head_radius);
  std::vector<std::optional<KneeFit>> fits(starts.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < starts.size(); ++i) {
    fits[i] = Refined(condyles, starts[i].cylinder);
  }
  std::optional<KneeFit> best;
  for (const auto& fit : fits) {
    if (!fit ||
        fit->cylinder.radius < kKneeSearch.least_condyle * head_radius ||
        fit->cylinder.radius > kKneeSearch.largest_condyle * head_radius) {
      continue;
    }
    if (!best || fit->points > best->points) best = fit;
  }
  return best;
}

}  // namespace musclewarp
