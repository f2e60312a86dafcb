// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace musclewarp {

// Signs of determinants of the coordinates as they are, without rounding: -1, 0
// or 1. Floating point decides where its error bound allows (Shewchuk 1997,
// "Adaptive Precision Floating-Point Arithmetic"), exact arithmetic elsewhere.

namespace internal {
// Below this a product may have lost digits to underflow.
constexpr double kUnderflow = 1e-280;
// Shewchuk's bounds are (7 + 56 e) e and (3 + 16 e) e with e = 2^-53.
constexpr double kOrientationBound = 8 * 0x1p-53;
constexpr double kOrientation2dBound = 4 * 0x1p-53;

int ExactOrientation(const Eigen::RowVector3d& a,
                     const Eigen::RowVector3d& b,
                     const Eigen::RowVector3d& c,
                     const Eigen::RowVector3d& d);
int ExactOrientation2d(
    double ax, double ay, double bx, double by, double cx, double cy);
}  // namespace internal

// The side of the plane abc on which d lies: 1 where ((b - a) x (c - a)) .
// (d - a) is positive, 0 on the plane.
inline int Orientation(const Eigen::RowVector3d& a,
                       const Eigen::RowVector3d& b,
                       const Eigen::RowVector3d& c,
                       const Eigen::RowVector3d& d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1], az = a[2] - d[2];
  const double bx = b[0] - d[0], by = b[1] - d[1], bz = b[2] - d[2];
  const double cx = c[0] - d[0], cy = c[1] - d[1], cz = c[2] - d[2];
  const double det = az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) +
                     cz * (ax * by - ay * bx);
  const double size = std::abs(az) * (std::abs(bx * cy) + std::abs(by * cx)) +
                      std::abs(bz) * (std::abs(cx * ay) + std::abs(cy * ax)) +
                      std::abs(cz) * (std::abs(ax * by) + std::abs(ay * bx));
  const double bound =
      internal::kOrientationBound * size + internal::kUnderflow;
  if (det > bound) return -1;
  if (det < -bound) return 1;
  return internal::ExactOrientation(a, b, c, d);
}

// The sign of (b - a) x (c - a) in the plane: 1 counterclockwise.
inline int Orientation2d(
    double ax, double ay, double bx, double by, double cx, double cy) {
  const double left = (ax - cx) * (by - cy);
  const double right = (ay - cy) * (bx - cx);
  const double bound =
      internal::kOrientation2dBound * (std::abs(left) + std::abs(right)) +
      internal::kUnderflow;
  if (left - right > bound) return 1;
  if (left - right < -bound) return -1;
  return internal::ExactOrientation2d(ax, ay, bx, by, cx, cy);
}

}  // namespace musclewarp
