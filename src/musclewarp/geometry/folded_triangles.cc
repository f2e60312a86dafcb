// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/folded_triangles.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>

namespace musclewarp {
namespace {

using Matrices = std::vector<Eigen::Matrix3d>;

// Returns for each vertex the sum of (rest edge)^T (deformed edge) over its
// edges, with one term for each triangle of an edge.
Matrices EdgeCovariances(const Points& rest,
                         const Points& deformed,
                         const Triangles& triangles) {
  Matrices covariances(rest.rows(), Eigen::Matrix3d::Zero());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int a = triangles(f, corner);
      const int b = triangles(f, (corner + 1) % 3);
      const Eigen::Matrix3d covariance =
          (rest.row(b) - rest.row(a)).transpose() *
          (deformed.row(b) - deformed.row(a));
      covariances[a] += covariance;
      covariances[b] += covariance;
    }
  }
  return covariances;
}

// Returns for each vertex the sum over the triangles around it of the values of
// their corners.
Matrices SummedOverNeighbours(const Matrices& values,
                              const Triangles& triangles) {
  Matrices sums(values.size(), Eigen::Matrix3d::Zero());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Eigen::Matrix3d sum = values[triangles(f, 0)] +
                                values[triangles(f, 1)] +
                                values[triangles(f, 2)];
    for (int corner = 0; corner < 3; ++corner) {
      sums[triangles(f, corner)] += sum;
    }
  }
  return sums;
}

// Returns the rotation R that maximises trace(R C), by a singular value
// decomposition.
Eigen::Matrix3d BestRotation(const Eigen::Matrix3d& covariance) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
      covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1, 1, 1);
  signs[2] = (svd.matrixV() * svd.matrixU().transpose()).determinant();
  return svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
}

// The derivatives of trace(exp([w]) M) at w = 0: how the rotation of which
// M = R C is made has to be turned to be the best one.
struct Turn {
  explicit Turn(const Eigen::Matrix3d& m)
      : slope(m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0)),
        curvature(m.trace() * Eigen::Matrix3d::Identity() -
                  (m + m.transpose()) / 2) {}

  // Returns a bound on the sine of the angle to the best rotation, or more than
  // one. Around an axis u, the trace is largest at the angle with the tangent
  // slope.u / u^T curvature u, so that the tangent is at most the length of the
  // slope over the least eigenvalue of the curvature, which Gershgorin's discs
  // bound from below.
  double LargestSine() const {
    double least = curvature(0, 0);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      least = std::min(least,
                       curvature(i, i) - std::abs(curvature(i, j)) -
                           std::abs(curvature(i, k)));
    }
    return least > 0 ? slope.norm() / least : 2;
  }

  Eigen::Vector3d slope;
  Eigen::Matrix3d curvature;  // its negative
};

// Returns the same rotation, found from one nearby by Newton's method on
// trace(exp([w]) R C). The function has no other local maximum on the
// rotations, so that a stationary point with a negative definite second
// derivative is the one.
Eigen::Matrix3d BestRotation(const Eigen::Matrix3d& covariance,
                             const Eigen::Matrix3d& nearby) {
  constexpr int kMaxSteps = 8;
  constexpr double kTolerance = 1e-6;  // rad; the error is its square
  Eigen::Matrix3d rotation = nearby;
  for (int step = 0; step < kMaxSteps; ++step) {
    const auto [slope, curvature] = Turn(rotation * covariance);
    const bool is_definite =
        curvature(0, 0) > 0 &&
        curvature.topLeftCorner<2, 2>().determinant() > 0 &&
        curvature.determinant() > 0;
    if (!is_definite) break;
    const Eigen::Vector3d turn = curvature.inverse() * slope;
    const double angle = turn.norm();
    if (!(angle < 1)) break;
    if (angle > 0) {
      rotation = Eigen::AngleAxisd(angle, turn / angle) * rotation;
    }
    if (angle < kTolerance) return rotation;
  }
  return BestRotation(covariance);
}

Eigen::RowVector3d Normal(const Points& points, const Eigen::RowVector3i& f) {
  const Eigen::RowVector3d a = points.row(f[0]);
  return (points.row(f[1]) - a).cross(points.row(f[2]) - a);
}

// If twice the area over the square of the longest edge is below this, rounding
// of the coordinates decides to which side the normal points.
constexpr double kNeedle = 1e-9;

bool IsNeedle(const Points& points, const Eigen::RowVector3i& f) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    longest = std::max(
        longest, (points.row(f[k]) - points.row(f[(k + 1) % 3])).squaredNorm());
  }
  return Normal(points, f).norm() <= kNeedle * longest;
}

}  // namespace

std::vector<FoldedTriangle> FoldedTriangles(const Points& rest,
                                            const Points& deformed,
                                            const Triangles& triangles) {
  CHECK_EQ(rest.rows(), deformed.rows());
  const Matrices covariances = SummedOverNeighbours(
      EdgeCovariances(rest, deformed, triangles), triangles);
  std::vector<FoldedTriangle> folded;
  // Triangles with neighbouring numbers are mostly neighbours on the surface
  // and have similar rotations, so that each starts from that of the one
  // before.
  constexpr Eigen::Index kTrianglesPerBlock = 128;
#pragma omp parallel for schedule(static)
  for (Eigen::Index begin = 0; begin < triangles.rows();
       begin += kTrianglesPerBlock) {
    const Eigen::Index end =
        std::min(begin + kTrianglesPerBlock, triangles.rows());
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    for (Eigen::Index f = begin; f < end; ++f) {
      if (IsNeedle(rest, triangles.row(f))) continue;
      const Eigen::Matrix3d covariance = covariances[triangles(f, 0)] +
                                         covariances[triangles(f, 1)] +
                                         covariances[triangles(f, 2)];
      const Eigen::RowVector3d rest_normal = Normal(rest, triangles.row(f));
      const Eigen::RowVector3d normal = Normal(deformed, triangles.row(f));
      const auto facing = [&] {
        return normal.dot(rest_normal * rotation.transpose());
      };
      // Most are so far from folded that the rotation nearby says so.
      if (facing() > 1.001 * Turn(rotation * covariance).LargestSine() *
                         rest_normal.norm() * normal.norm()) {
        continue;
      }
      rotation = BestRotation(covariance, rotation);
      if (facing() < 0) {
#pragma omp critical(folded_triangles)
        folded.push_back({static_cast<int>(f), rotation});
      }
    }
  }
  std::sort(folded.begin(), folded.end(), [](const auto& a, const auto& b) {
    return a.triangle < b.triangle;
  });
  return folded;
}

}  // namespace musclewarp
