// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_push.h"

#include <glog/logging.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "musclewarp/geometry/spread_points.h"
#include "musclewarp/solver/bone_touches.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {
namespace {

double Number(const char* name, double value) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : value;
}
const double kSamples = Number("PUSH_SAMPLES", 4);
const double kMostSamples = 1600;
const double kClearance = Number("PUSH_GAP", 1);
const double kStiffness = Number("PUSH_HARD", 40);
const double kOnset = Number("PUSH_SOFT", 1);
const double kLongestMove = Number("PUSH_LONGEST", 4);
const int kRounds = static_cast<int>(Number("PUSH_ROUNDS", 2));
const int kLastRounds = static_cast<int>(Number("PUSH_LAST", 40));
const double kClose = Number("PUSH_CLOSE", 1e-6);
const bool kDebug = Number("PUSH_DEBUG", 0) != 0;

// The least of 1/2 y^T f + sum k phi(b - y) with y = M f, where f are forces
// along the normals of samples near bones, y how far they give way, and b what
// they lack while nothing gives way: the energy of the push with the distances
// linear.
class LinearPush {
 public:
  LinearPush(const BonePush& push, Eigen::MatrixXd response, Eigen::VectorXd lack)
      : push_(push),
        response_(std::move(response)),
        lack_(std::move(lack)),
        forces_(Eigen::VectorXd::Zero(lack_.size())),
        yields_(forces_) {}

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
      const double stiffness =
          std::max(bone.stiffness, 1e-9 * push_.stiffness);
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
  const Eigen::MatrixXd response_;  // M
  const Eigen::VectorXd lack_;      // b
  Eigen::VectorXd forces_;          // f
  Eigen::VectorXd yields_;          // y
};

// The forces on samples, and how they move the samples.
struct Push {
  Points forces, moved;  // S x 3
};

double EnergyOf(const BonePush& push,
                const Push& now,
                const std::vector<BoneTouch>& touches) {
  double energy = now.forces.cwiseProduct(now.moved).sum() / 2;
  for (const BoneTouch& touch : touches) {
    energy += ForceAt(push, touch.lack).energy;
  }
  return energy;
}

// The least energy with the distances linear about the current push.
Push NextPush(const BonePush& push,
              const std::vector<BoneTouch>& touches,
              const Push& now) {
  const auto count = static_cast<Eigen::Index>(touches.size());
  std::vector<int> samples;
  Points normals(count, 3);
  Eigen::VectorXd lack(count);
  for (Eigen::Index a = 0; a < count; ++a) {
    const BoneTouch& touch = touches[a];
    samples.push_back(touch.sample);
    normals.row(a) = touch.normal;
    lack[a] = touch.lack + touch.normal.dot(now.moved.row(touch.sample));
  }
  LinearPush linear(push,
                    push.response(samples, samples)
                        .cwiseProduct(normals * normals.transpose()),
                    std::move(lack));
  const Points forces = linear.Solve().asDiagonal() * normals;
  Push next = {Points::Zero(now.forces.rows(), 3), {}};
  for (Eigen::Index a = 0; a < count; ++a) {
    next.forces.row(samples[a]) += forces.row(a);
  }
  next.moved = push.response(Eigen::all, samples) * forces;
  return next;
}

Push Between(const Push& a, const Push& b, double share) {
  return {a.forces + share * (b.forces - a.forces),
          a.moved + share * (b.moved - a.moved)};
}

}  // namespace

std::shared_ptr<const BonePush> PrepareBonePush(
    const std::vector<BodyField>& bodies, const MuscleModel& model) {
  if (!model.HasLines() || bodies.empty()) return nullptr;
  auto push = std::make_shared<BonePush>();
  push->bodies = bodies;
  const std::vector<int> samples = SpreadPoints(
      model.fine_rest,
      static_cast<int>(std::min(
          kMostSamples,
          kSamples * static_cast<double>(model.coarse_rest.rows()))));
  push->fine_from_coarse = model.fine_from_coarse(samples, Eigen::all);
  const Points rest = push->fine_from_coarse * model.coarse_rest;
  push->clearances.setConstant(samples.size(), bodies.size(), kClearance);
  for (size_t b = 0; b < bodies.size(); ++b) {
    DistanceField::Value value;
    for (Eigen::Index v = 0; v < rest.rows(); ++v) {
      if (bodies[b].field->IsBelow(kClearance, rest.row(v), &value)) {
        push->clearances(v, b) = value.distance;
      }
    }
  }
  push->reach = model.normal_matrix.solve(
      Eigen::MatrixXd(push->fine_from_coarse.transpose()));
  push->response = push->fine_from_coarse * push->reach;
  push->onset = kOnset;
  push->stiffness = kStiffness / push->response.diagonal().mean();
  return push;
}

std::vector<Points> FollowPush(const BonePush& push,
                               const std::vector<ScenePose>& way,
                               const std::vector<Points>& free) {
  std::vector<Points> displacements;
  const Eigen::Index count = push.fine_from_coarse.rows();
  Push now = {Points::Zero(count, 3), Points::Zero(count, 3)};
  for (size_t k = 0; k < way.size(); ++k) {
    const Points places = push.fine_from_coarse * free[k];
    const bool is_last = k + 1 == way.size();
    const int rounds = is_last ? kLastRounds : kRounds;
    double change = 0, energy = 0;
    int num = 0, round = 0, halvings = 0;
    std::vector<BoneTouch> touches =
        TouchesAt(push, way[k], places + now.moved, kLongestMove);
    energy = EnergyOf(push, now, touches);
    for (; round < rounds && energy > 0; ++round) {
      const Push next = NextPush(push, touches, now);
      const double longest =
          (next.moved - now.moved).rowwise().norm().maxCoeff();
      if (longest < kClose) break;
      double share = std::min(1.0, kLongestMove / longest);
      Push tried;
      for (int halving = 0;; ++halving, share /= 2) {
        tried = Between(now, next, share);
        touches = TouchesAt(push, way[k], places + tried.moved, kLongestMove);
        const double then = EnergyOf(push, tried, touches);
        if (then <= energy || halving == 6) { energy = then; break; }
        ++halvings;
      }
      change = share * longest;
      now = std::move(tried);
    }
    if (kDebug && is_last) {
      for (const BoneTouch& touch : touches) num += touch.lack > 0;
      LOG(INFO) << "push of " << way.size() << " steps: " << num << " touches, "
                << touches.size() << " near of "
                << count << ", rounds " << round << " halvings " << halvings << " last change " << change
                << ", moved " << now.moved.rowwise().norm().maxCoeff();
    }
    displacements.push_back(push.reach * now.forces);
  }
  return displacements;
}

}  // namespace musclewarp
