// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/bounding_capsule.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// A bound on the rounding of coordinates, relative to their size.
constexpr double kRounding = 1e-12;

double PointSegmentDistance(const RowVector3d& p,
                            const RowVector3d& start,
                            const RowVector3d& end) {
  const RowVector3d way = end - start;
  const double length = way.squaredNorm();
  const double place =
      length > 0 ? std::clamp((p - start).dot(way) / length, 0.0, 1.0) : 0;
  return (start + place * way - p).norm();
}

}  // namespace

Capsule BoundingCapsule(const Points& points) {
  Capsule capsule;
  if (points.rows() == 0) return capsule;
  const RowVector3d mean = points.colwise().mean();
  const Points centred = points.rowwise() - mean;
  const Eigen::Matrix3d covariance = centred.transpose() * centred;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const RowVector3d axis = solver.eigenvectors().col(2).transpose();
  const Eigen::VectorXd along = centred * axis.transpose();
  const Eigen::VectorXd beside = (centred - along * axis).rowwise().norm();
  capsule.radius = beside.maxCoeff();
  // Every point is in the half ball around an end, or between the two ends.
  double low = INFINITY;
  double high = -INFINITY;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double reach = std::sqrt(
        std::max(0.0, capsule.radius * capsule.radius - beside[i] * beside[i]));
    low = std::min(low, along[i] + reach);
    high = std::max(high, along[i] - reach);
  }
  if (low > high) low = high = 0.5 * (low + high);
  capsule.start = mean + low * axis;
  capsule.end = mean + high * axis;
  capsule.radius += kRounding * (capsule.radius + points.cwiseAbs().maxCoeff());
  return capsule;
}

bool Overlap(const Capsule& a, const Capsule& b) {
  if (a.radius < 0 || b.radius < 0) return false;
  return SegmentDistance(a.start, a.end, b.start, b.end) <= a.radius + b.radius;
}

double SegmentDistance(const RowVector3d& a_start,
                       const RowVector3d& a_end,
                       const RowVector3d& b_start,
                       const RowVector3d& b_end) {
  // Either the closest points are inside both segments, or one is an end.
  double distance = std::min({PointSegmentDistance(a_start, b_start, b_end),
                              PointSegmentDistance(a_end, b_start, b_end),
                              PointSegmentDistance(b_start, a_start, a_end),
                              PointSegmentDistance(b_end, a_start, a_end)});
  const RowVector3d a = a_end - a_start;
  const RowVector3d b = b_end - b_start;
  const RowVector3d between = b_start - a_start;
  const RowVector3d normal = a.cross(b);
  const double size = normal.squaredNorm();
  if (size > 0) {
    const double on_a = between.cross(b).dot(normal) / size;
    const double on_b = between.cross(a).dot(normal) / size;
    if (0 <= on_a && on_a <= 1 && 0 <= on_b && on_b <= 1) {
      distance =
          std::min(distance, std::abs(between.dot(normal)) / std::sqrt(size));
    }
  }
  return distance;
}

}  // namespace musclewarp
