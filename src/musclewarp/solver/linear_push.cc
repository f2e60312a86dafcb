// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/linear_push.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/solver/bone_touches.h"

namespace musclewarp {
namespace {

class LinearPush {
 public:
  LinearPush(const BonePush& push,
             const Eigen::MatrixXd& response,
             const Eigen::VectorXd& lack,
             const Eigen::VectorXd& start)
      : push_(push),
        response_(response),
        lack_(lack),
        forces_(start),
        yields_(response * start) {}

  // Newton's method on the samples that touch, each step as long as it has to
  // be: the energy is convex, and has continuous second derivatives.
  const Eigen::VectorXd& Solve() {
    constexpr int kMaxSteps = 40;
    constexpr double kTolerance = 1e-12;  // of the energy
    for (int step = 0; step < kMaxSteps; ++step) {
      const Eigen::VectorXd way = NewtonForces() - forces_;
      const Eigen::VectorXd yielding = response_ * way;
      if (!(std::abs(way.dot(yielding)) > kTolerance * push_.stiffness)) break;
      const double length = LeastAlong(way, yielding);
      forces_ += length * way;
      yields_ += length * yielding;
    }
    return forces_;
  }

 private:
  Eigen::VectorXd NewtonForces() const {
    std::vector<int> active;
    for (int a = 0; a < static_cast<int>(lack_.size()); ++a) {
      if (lack_[a] > yields_[a]) active.push_back(a);
    }
    Eigen::MatrixXd system = response_(active, active);
    Eigen::VectorXd right(active.size());
    for (size_t i = 0; i < active.size(); ++i) {
      const int a = active[i];
      const BoneForce bone = ForceAt(push_, lack_[a] - yields_[a]);
      // A touch that only begins has next to no stiffness.
      const double stiffness = std::max(bone.stiffness, 1e-9 * push_.stiffness);
      system(i, i) += 1 / stiffness;
      right[i] = bone.force / stiffness + yields_[a];
    }
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(lack_.size());
    if (active.empty()) return forces;
    const Eigen::VectorXd solved = system.llt().solve(right);
    forces(active) = solved;
    return forces;
  }

  // Where along the way the energy is least, by bisection of its slope; 1 if it
  // still falls there.
  double LeastAlong(const Eigen::VectorXd& way,
                    const Eigen::VectorXd& yielding) const {
    const double first = forces_.dot(yielding), second = way.dot(yielding);
    const auto slope = [&](double t) {
      double sum = first + t * second;
      for (Eigen::Index a = 0; a < lack_.size(); ++a) {
        sum -= ForceAt(push_, lack_[a] - yields_[a] - t * yielding[a]).force *
               yielding[a];
      }
      return sum;
    };
    double low = 0, high = 1;
    if (slope(high) <= 0) return high;
    for (int i = 0; i < 30; ++i) {
      const double middle = (low + high) / 2;
      (slope(middle) > 0 ? high : low) = middle;
    }
    return low;
  }

  const BonePush& push_;
  const Eigen::MatrixXd& response_;  // M
  const Eigen::VectorXd& lack_;      // b
  Eigen::VectorXd forces_;           // f
  Eigen::VectorXd yields_;           // y
};

}  // namespace

Eigen::VectorXd LinearPushForces(const BonePush& push,
                                 const Eigen::MatrixXd& response,
                                 const Eigen::VectorXd& lack,
                                 const Eigen::VectorXd& start) {
  return LinearPush(push, response, lack, start).Solve();
}

}  // namespace musclewarp
