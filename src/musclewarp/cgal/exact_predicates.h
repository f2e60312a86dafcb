// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace musclewarp {

// Orientation and Orientation2d return the sign of a determinant, -1, 0 or 1,
// for the coordinates exactly as they are stored. All tests for intersection
// rest on them, since one wrong sign makes a test contradict itself where
// points are nearly in one plane.
//
// The determinant is computed in floating point first. Its sign is returned if
// the value is larger than a bound on the rounding error (Shewchuk 1997,
// "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates"); this is the usual case, and it is inline. Otherwise CGAL
// decides in exact arithmetic. Coordinates must be finite and their products
// must not overflow.

namespace internal {

// A product whose absolute value is below this may have lost digits to
// underflow, so that the relative error bound does not hold for it.
constexpr double kUnderflow = 1e-280;

// Bounds on the error of the determinants relative to the sum of the absolute
// values of their terms. With e = 2^-53, Shewchuk proves (7 + 56 e) e and
// (3 + 16 e) e; these are the next larger round numbers.
constexpr double kOrientationBound = 8 * 0x1p-53;
constexpr double kOrientation2dBound = 4 * 0x1p-53;

// The same signs, computed in exact arithmetic from the start.
int ExactOrientation(const Eigen::RowVector3d& a,
                     const Eigen::RowVector3d& b,
                     const Eigen::RowVector3d& c,
                     const Eigen::RowVector3d& d);
int ExactOrientation2d(
    double ax, double ay, double bx, double by, double cx, double cy);

}  // namespace internal

// Returns the side of the plane abc on which d lies: the sign of
// ((b - a) x (c - a)) . (d - a). It is 1 on the side from which a, b, c run
// counterclockwise, -1 on the other side, and 0 if the four points are in one
// plane. Swapping two points changes the sign.
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

// Returns the orientation of a triangle in the plane: the sign of
// (b - a) x (c - a). It is 1 if a, b, c run counterclockwise, -1 if they run
// clockwise, and 0 if they are on one line. Swapping two points changes the
// sign.
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
