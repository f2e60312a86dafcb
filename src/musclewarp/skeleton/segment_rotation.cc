// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/segment_rotation.h"

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

namespace musclewarp {
namespace {

// Twist at one end of the segment beyond the smallest rotation, if its body is
// known.
std::optional<double> EndTwist(const LineTarget& target,
                               int point,
                               const Eigen::Matrix3d& smallest,
                               const Eigen::Vector3d& target_direction) {
  if (target.body_rotations.empty() || !target.body_rotations[point]) return {};
  return TwistAngle(*target.body_rotations[point] * smallest.transpose(),
                    target_direction);
}

}  // namespace

Eigen::Matrix3d SmallestRotation(const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to) {
  if (from.squaredNorm() == 0 || to.squaredNorm() == 0) {
    return Eigen::Matrix3d::Identity();
  }
  // As Quaterniond::FromTwoVectors, but for opposite vectors, for which that
  // has a singular value decomposition, which takes eight seconds to compile.
  constexpr double kOpposite = -1 + 1e-12;
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < kOpposite) {
    // Half a turn about any axis across a, and the small rest of the way.
    return SmallestRotation(-a, b) *
           Eigen::AngleAxisd(M_PI, a.unitOrthogonal()).toRotationMatrix();
  }
  const double scale = std::sqrt((1 + cosine) * 2);
  Eigen::Quaterniond rotation;
  rotation.vec() = a.cross(b) * (1 / scale);
  rotation.w() = scale * 0.5;
  return rotation.normalized().toRotationMatrix();
}

double TwistAngle(const Eigen::Matrix3d& rotation,
                  const Eigen::Vector3d& axis) {
  const Eigen::Quaterniond q(rotation);
  const double sine = q.vec().dot(axis);
  if (sine == 0 && q.w() == 0) return 0;
  return std::remainder(2 * std::atan2(sine, q.w()), 2 * M_PI);
}

Eigen::Matrix3d SegmentRotation(const ActionLine& line,
                                const LineTarget& target,
                                const SegmentPoint& place,
                                bool use_body_twist) {
  const int begin = place.segment;
  const int end = place.segment + 1;
  const Eigen::Vector3d rest_direction =
      (line.rest.row(end) - line.rest.row(begin)).transpose();
  const Eigen::Vector3d target_direction =
      (target.points.row(end) - target.points.row(begin)).transpose();
  const Eigen::Matrix3d smallest =
      SmallestRotation(rest_direction, target_direction);
  if (!use_body_twist || target_direction.squaredNorm() == 0) return smallest;

  const Eigen::Vector3d axis = target_direction.normalized();
  const auto begin_twist = EndTwist(target, begin, smallest, axis);
  const auto end_twist = EndTwist(target, end, smallest, axis);
  if (!begin_twist && !end_twist) return smallest;
  const double twist_0 = begin_twist ? *begin_twist : *end_twist;
  const double twist_1 = end_twist ? *end_twist : *begin_twist;
  // The short way round, so that twists of 179 and -179 degrees are neighbours.
  const double turn = std::remainder(twist_1 - twist_0, 2 * M_PI);
  return Eigen::AngleAxisd(twist_0 + place.t * turn, axis).toRotationMatrix() *
         smallest;
}

}  // namespace musclewarp
