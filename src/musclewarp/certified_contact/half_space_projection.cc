// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/half_space_projection.h"

#include <Eigen/Householder>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// A point that violates a half-space by less than this is inside it, mm.
constexpr double kInsideTolerance = 1e-9;

// A component of a unit normal orthogonal to others that is shorter than this
// is rounding error.
constexpr double kParallel = 1e-4;

template <int kDimension>
using Vector = Eigen::Matrix<double, 1, kDimension>;

// The planes that push the point, and their multipliers.
template <int kDimension>
struct ActiveSet {
  // One coefficient per plane.
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kDimension, 1>;

  std::array<Vector<kDimension>, kDimension> normals;
  std::array<double, kDimension> pushes;
  int size = 0;

  void Drop(int i) {
    --size;
    normals[i] = normals[size];
    pushes[i] = pushes[size];
  }

  // Splits normal = sum_i shares_i normals_i + across, where `across` is
  // orthogonal to all normals of the set, and returns `across`.
  Vector<kDimension> Split(const Vector<kDimension>& normal,
                           Numbers* shares) const {
    Eigen::Matrix<double,
                  Eigen::Dynamic,
                  kDimension,
                  Eigen::RowMajor,
                  kDimension,
                  kDimension>
        all(size, kDimension);
    for (int i = 0; i < size; ++i) all.row(i) = normals[i];
    shares->resize(size);
    if (size == 0) return normal;
    // QR is accurate even for nearly parallel normals. This is what
    // Eigen::HouseholderQR does with few columns; the class itself would also
    // compile, for ten seconds, what it does with many.
    Eigen::Matrix<double, kDimension, Eigen::Dynamic, 0, kDimension, kDimension>
        qr = all.transpose();
    Eigen::Matrix<double, kDimension, 1> solution = normal.transpose();
    Eigen::Matrix<double, kDimension, 1> workspace;
    for (int k = 0; k < size; ++k) {
      const int below = kDimension - k - 1;
      double coefficient, diagonal;
      qr.col(k).tail(below + 1).makeHouseholderInPlace(coefficient, diagonal);
      qr(k, k) = diagonal;
      const auto essential = qr.col(k).tail(below);
      qr.bottomRightCorner(below + 1, size - k - 1)
          .applyHouseholderOnTheLeft(essential, coefficient, workspace.data());
      solution.tail(below + 1).applyHouseholderOnTheLeft(
          essential, coefficient, workspace.data());
    }
    for (int k = size - 1; k >= 0; --k) {
      if (solution[k] == 0) continue;  // also with a zero on the diagonal
      solution[k] /= qr(k, k);
      for (int i = 0; i < k; ++i) solution[i] -= solution[k] * qr(i, k);
    }
    *shares = solution.head(size);
    if (size == kDimension) return Vector<kDimension>::Zero();
    return normal - shares->transpose() * all;
  }
};

// The method of ProjectIntoHalfSpaces in any dimension, for half-spaces i with
// `violation(i, point)` and `normal(i)`.
template <int kDimension, class Violation, class Normal>
bool Project(int count,
             const Violation& violation,
             const Normal& normal,
             double farthest,
             Vector<kDimension>* point) {
  constexpr int kMostChanges = 60;
  ActiveSet<kDimension> active;
  Vector<kDimension> moved = *point;
  int worst = -1;
  double push = 0;  // the multiplier of the worst plane
  for (int change = 0; change < kMostChanges; ++change) {
    if (worst < 0) {
      double most = kInsideTolerance;
      for (int i = 0; i < count; ++i) {
        const double here = violation(i, moved);
        if (here > most) {
          most = here;
          worst = i;
        }
      }
      if (worst < 0) {
        *point = moved;
        return true;
      }
      push = 0;
    }
    typename ActiveSet<kDimension>::Numbers shares;
    const Vector<kDimension> across = active.Split(normal(worst), &shares);
    const double slope = across.squaredNorm();
    // The step length to the plane, and the one at which the multiplier of an
    // active plane becomes zero.
    const double to_border = slope > kParallel * kParallel
                                 ? violation(worst, moved) / slope
                                 : kInfinity;
    double to_release = kInfinity;
    int released = -1;
    for (int i = 0; i < active.size; ++i) {
      if (shares[i] > 0 && active.pushes[i] < to_release * shares[i]) {
        to_release = active.pushes[i] / shares[i];
        released = i;
      }
    }
    const double step = std::min(to_border, to_release);
    if (step == kInfinity) return false;
    if (to_border < kInfinity) moved += step * across;
    if ((moved - *point).squaredNorm() > farthest * farthest) return false;
    for (int i = 0; i < active.size; ++i) active.pushes[i] -= step * shares[i];
    push += step;
    if (step == to_border) {
      active.normals[active.size] = normal(worst);
      active.pushes[active.size] = push;
      ++active.size;
      worst = -1;
    } else {
      active.Drop(released);
    }
  }
  return false;
}

}  // namespace

bool ProjectIntoHalfSpaces(const HalfSpace* spaces,
                           int count,
                           double farthest,
                           RowVector3d* point) {
  return Project<3>(
      count,
      [&](int i, const RowVector3d& p) {
        return spaces[i].level - spaces[i].normal.dot(p);
      },
      [&](int i) -> const RowVector3d& { return spaces[i].normal; },
      farthest,
      point);
}

void CompromiseBetweenHalfSpaces(const HalfSpace* spaces,
                                 int count,
                                 double violation_weight,
                                 RowVector3d* point) {
  // The fourth unknown is the violation times its weight, so that the objective
  // is a squared distance.
  const double share = 1 / violation_weight;
  const double length = std::sqrt(1 + share * share);
  Vector<4> lifted;
  lifted << *point, 0;
  const bool is_found = Project<4>(
      count,
      [&](int i, const Vector<4>& p) {
        return (spaces[i].level - spaces[i].normal.dot(p.head<3>()) -
                share * p[3]) /
               length;
      },
      [&](int i) {
        Vector<4> normal;
        normal << spaces[i].normal, share;
        return Vector<4>(normal / length);
      },
      kInfinity,
      &lifted);
  if (is_found) *point = lifted.head<3>();
}

void ApproachHalfSpaces(const HalfSpace* spaces,
                        int count,
                        int turns,
                        RowVector3d* point) {
  constexpr double kTolerance = 1e-4;  // mm
  std::vector<double> pushes(count, 0);
  for (int turn = 0; turn < turns; ++turn) {
    double change = 0;
    for (int i = 0; i < count; ++i) {
      const double step =
          std::max(spaces[i].level - spaces[i].normal.dot(*point), -pushes[i]);
      pushes[i] += step;
      *point += step * spaces[i].normal;
      change = std::max(change, std::abs(step));
    }
    if (change < kTolerance) return;
  }
}

}  // namespace musclewarp
