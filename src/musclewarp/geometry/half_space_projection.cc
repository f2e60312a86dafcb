// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/half_space_projection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "musclewarp/base/infinity.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::Vector3d;

// A point that violates a half-space by less than this is inside it, mm.
constexpr double kInsideTolerance = 1e-9;

// If the part of a unit normal that is orthogonal to others is shorter than
// this, it is rounding error.
constexpr double kParallel = 1e-4;

// The planes that push the point, and their multipliers.
struct ActiveSet {
  std::array<RowVector3d, 3> normals;
  std::array<double, 3> pushes;
  int size = 0;

  void Drop(int i) {
    --size;
    normals[i] = normals[size];
    pushes[i] = pushes[size];
  }

  // Splits normal = sum_i shares_i normals_i + across, where `across` is
  // orthogonal to all normals of the set, and returns `across`.
  RowVector3d Split(const RowVector3d& normal, Vector3d* shares) const {
    shares->setZero();
    if (size == 0) return normal;
    if (size == 1) {
      (*shares)[0] = normal.dot(normals[0]);
      return normal - (*shares)[0] * normals[0];
    }
    const RowVector3d& a = normals[0];
    const RowVector3d& b = normals[1];
    const RowVector3d c = size == 3 ? normals[2] : RowVector3d(a.cross(b));
    // Solve by Cramer's rule. If there are two normals, c is orthogonal to
    // both.
    const RowVector3d bc = b.cross(c);
    const double determinant = a.dot(bc);
    (*shares)[0] = normal.dot(bc) / determinant;
    (*shares)[1] = normal.dot(c.cross(a)) / determinant;
    const double along = normal.dot(a.cross(b)) / determinant;
    if (size == 2) return along * c;
    (*shares)[2] = along;
    return RowVector3d::Zero();
  }
};

}  // namespace

bool ProjectIntoHalfSpaces(const HalfSpace* spaces,
                           int count,
                           double farthest,
                           RowVector3d* point) {
  constexpr int kMostChanges = 60;
  ActiveSet active;
  RowVector3d moved = *point;
  const HalfSpace* worst = nullptr;
  double push = 0;  // the multiplier of the worst one
  for (int change = 0; change < kMostChanges; ++change) {
    if (!worst) {
      double most = kInsideTolerance;
      for (int i = 0; i < count; ++i) {
        const double violation = spaces[i].level - spaces[i].normal.dot(moved);
        if (violation > most) {
          most = violation;
          worst = &spaces[i];
        }
      }
      if (!worst) {
        *point = moved;
        return true;
      }
      push = 0;
    }
    Vector3d shares;
    const RowVector3d across = active.Split(worst->normal, &shares);
    const double slope = across.squaredNorm();
    // The step until the plane is reached, and the step until one of the active
    // planes would have to pull.
    const double to_border =
        slope > kParallel * kParallel
            ? (worst->level - worst->normal.dot(moved)) / slope
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
      active.normals[active.size] = worst->normal;
      active.pushes[active.size] = push;
      ++active.size;
      worst = nullptr;
    } else {
      active.Drop(released);
    }
  }
  return false;
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
