// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/revolution_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "musclewarp/joints/joint_search.h"

namespace musclewarp {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// The lines (u, v) that minimise x^T m x under |u| = 1, and the next best: v
// follows from u, so that u is an eigenvector of a Schur complement.
struct BestLines {
  Vector6d first, second;
};
BestLines LinesOf(const Matrix6d& m) {
  const Eigen::Matrix3d uu = m.topLeftCorner<3, 3>();
  const Eigen::Matrix3d uv = m.topRightCorner<3, 3>();
  const Eigen::Matrix3d v_from_u =
      -m.bottomRightCorner<3, 3>().ldlt().solve(uv.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(uu +
                                                              uv * v_from_u);
  BestLines lines;
  for (const auto& [line, column] :
       {std::pair(&lines.first, 0), {&lines.second, 1}}) {
    const Eigen::Vector3d u = solver.eigenvectors().col(column);
    *line << u, v_from_u * u;
  }
  return lines;
}

}  // namespace

std::optional<RevolutionFit> FitRevolution(const SurfacePoints& surface) {
  constexpr int kRounds = 8;  // of weights
  if (surface.size() < 6) return std::nullopt;
  const Eigen::RowVector3d mean = surface.points.colwise().mean();
  Eigen::Matrix<double, Eigen::Dynamic, 6> normals(surface.size(), 6);
  for (int i = 0; i < surface.size(); ++i) {
    const Eigen::RowVector3d normal = surface.normals.row(i);
    normals.row(i) << (surface.points.row(i) - mean).cross(normal), normal;
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(surface.size());
  BestLines lines;
  for (int round = 0; round < kRounds; ++round) {
    lines = LinesOf(normals.transpose() * weights.asDiagonal() * normals);
    const Eigen::ArrayXd passes = normals * lines.first;
    weights = (1 + (passes / kJointSearch.fit.pass_scale).square()).rsqrt();
  }
  RevolutionFit fit;
  const double total = weights.sum();
  const auto spread = [&](const Vector6d& line) {
    const Eigen::ArrayXd passes = normals * line;
    return std::sqrt((weights.array() * passes.square()).sum() / total);
  };
  fit.spread = spread(lines.first);
  fit.next_spread = spread(lines.second);
  const Eigen::Vector3d u = lines.first.head<3>();
  // The moment of the axis; its part along u is the pitch of a screw, which a
  // surface of revolution does not have.
  fit.axis.direction = u;
  fit.axis.point =
      mean.transpose() + u.cross(Eigen::Vector3d(lines.first.tail<3>()));
  return fit;
}

}  // namespace musclewarp
