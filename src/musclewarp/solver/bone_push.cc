// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bone_push.h"

#include <glog/logging.h>

#include <algorithm>
#include <string>
#include <utility>

#include "musclewarp/geometry/spread_points.h"
#include "musclewarp/geometry/thin_product.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/screw_motion.h"
#include "musclewarp/solver/bone_touches.h"
#include "musclewarp/solver/linear_push.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {
namespace {

// A round looks at samples so near to touching, and moves them no farther, mm.
constexpr double kNear = 1.5;

// Rounds end when none would move a sample by as much (mm), or after so many:
// in a step on the way, and in the pose itself.
constexpr double kClose = 1e-6;
constexpr int kRounds = 2;
constexpr int kLastRounds = 40;

// The forces on samples, and how they move the samples.
struct Push {
  Points forces, moved;  // S x 3
};

// 1/2 |dX|^2 + m/2 |dX - dX before|^2 and the energy of the touches.
double EnergyOf(const BonePush& push,
                const Push& before,
                double drag,
                const Push& now,
                const std::vector<BoneTouch>& touches) {
  const double shape = now.forces.cwiseProduct(now.moved).sum();
  const double change =
      (now.forces - before.forces).cwiseProduct(now.moved - before.moved).sum();
  double energy = (shape + drag * change) / 2;
  for (const BoneTouch& touch : touches) {
    energy += ForceAt(push, touch.lack).energy;
  }
  return energy;
}

// The least energy with the distances linear about the current push.
Push NextPush(const BonePush& push,
              const std::vector<BoneTouch>& touches,
              const Push& before,
              double drag,
              const Push& now) {
  const double kept = drag / (1 + drag);
  const auto count = static_cast<Eigen::Index>(touches.size());
  std::vector<int> samples;
  Points normals(count, 3);
  Eigen::VectorXd lack(count), start(count);
  const Points since_before = now.forces - kept * before.forces;
  for (Eigen::Index a = 0; a < count; ++a) {
    const BoneTouch& touch = touches[a];
    const int v = touch.sample;
    samples.push_back(v);
    normals.row(a) = touch.normal;
    lack[a] = touch.lack +
              touch.normal.dot(now.moved.row(v) - kept * before.moved.row(v));
    start[a] =
        std::max(0.0, (1 + drag) * touch.normal.dot(since_before.row(v)));
  }
  const Eigen::MatrixXd response =
      push.response(samples, samples)
          .cwiseProduct(normals * normals.transpose()) /
      (1 + drag);
  const Points forces =
      LinearPushForces(push, response, lack, start).asDiagonal() * normals /
      (1 + drag);
  Push next = {kept * before.forces, kept * before.moved};
  for (Eigen::Index a = 0; a < count; ++a) {
    next.forces.row(samples[a]) += forces.row(a);
  }
  next.moved += ThinTransposedProduct(push.response, samples, forces);
  return next;
}

Push Between(const Push& a, const Push& b, double share) {
  return {a.forces + share * (b.forces - a.forces),
          a.moved + share * (b.moved - a.moved)};
}

// How the bodies move from one pose to the next.
std::vector<ScrewMotion> MotionsBetween(const BonePush& push,
                                        const ScenePose& from,
                                        const ScenePose& to) {
  std::vector<ScrewMotion> motions;
  for (const BoneField& bone : push.bones) {
    motions.emplace_back(BodyTransform(to, bone.body) *
                         RigidInverse(BodyTransform(from, bone.body)));
  }
  return motions;
}

ScenePose PartOf(const BonePush& push,
                 const ScenePose& from,
                 const std::vector<ScrewMotion>& motions,
                 double part) {
  ScenePose pose;
  for (size_t b = 0; b < motions.size(); ++b) {
    const std::string& body = push.bones[b].body;
    pose.bodies[body] = motions[b].Part(part) * BodyTransform(from, body);
  }
  return pose;
}

// Returns the places of samples at a part of the way from pose k - 1 to pose k:
// cubics through those of the poses.
Points PlacesAt(const std::vector<Points>& places, int k, double t) {
  const auto at = [&](int i) -> const Points& { return places[i]; };
  const int last = static_cast<int>(places.size()) - 1;
  const Points way = at(k) - at(k - 1);
  const Points begin = k > 1 ? Points((at(k) - at(k - 2)) / 2) : way;
  const Points end = k < last ? Points((at(k + 1) - at(k - 1)) / 2) : way;
  const double in = t * (1 - t) * (1 - t), out = t * t * (1 - t);
  return at(k - 1) + t * t * (3 - 2 * t) * way + in * begin - out * end;
}

// Brings a push to the least energy in a pose, from where it is. `places`: of
// the samples without the push.
void Settle(const BonePush& push,
            BoneTouches* near,
            const ScenePose& pose,
            const Points& places,
            double drag,
            int max_rounds,
            Push* now) {
  constexpr int kMostHalvings = 6;
  constexpr double kRounding = 1e-12;
  const Push before = *now;
  std::vector<BoneTouch> touches = near->At(pose, places + now->moved, kNear);
  double energy = EnergyOf(push, before, drag, *now, touches);
  for (int round = 0; round < max_rounds && energy > 0; ++round) {
    const Push next = NextPush(push, touches, before, drag, *now);
    const double longest =
        (next.moved - now->moved).rowwise().norm().maxCoeff();
    if (longest < kClose) break;
    double share = std::min(1.0, kNear / longest);
    for (int halving = 0;; ++halving, share /= 2) {
      Push tried = Between(*now, next, share);
      touches = near->At(pose, places + tried.moved, kNear);
      const double then = EnergyOf(push, before, drag, tried, touches);
      if (then > energy * (1 + kRounding) && halving < kMostHalvings) continue;
      energy = then;
      *now = std::move(tried);
      break;
    }
  }
}

// Returns the least energy near where the flow has come to, which is a step
// behind; where the muscle slips, no farther than max_lag from there.
Push NearLeast(const BonePush& push,
               BoneTouches* near,
               const ScenePose& pose,
               const Points& places,
               const Push& flow) {
  Push least = flow;
  Settle(push, near, pose, places, /*drag=*/0, kLastRounds, &least);
  const double behind = (least.moved - flow.moved).rowwise().norm().maxCoeff();
  const double most = push.options.max_lag;
  return behind > most ? Between(flow, least, most / behind) : least;
}

}  // namespace

int NumPushSamples(const BonePushOptions& options, int coarse_vertices) {
  constexpr int kMostCoarseVertices = 400;
  return options.samples_per_coarse_vertex *
         std::min(kMostCoarseVertices, coarse_vertices);
}

std::shared_ptr<const BonePush> PrepareBonePush(
    const BonePushOptions& options,
    const std::vector<BoneField>& bones,
    const MuscleModel& model) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  if (!model.HasLines() || bones.empty()) return nullptr;
  auto push = std::make_shared<BonePush>();
  push->options = options;
  push->bones = bones;
  const std::vector<int> samples = SpreadPoints(
      model.fine_rest,
      NumPushSamples(options, static_cast<int>(model.coarse_rest.rows())));
  push->fine_from_coarse = RowsOf(model.fine_from_coarse, samples);
  const Points rest = push->fine_from_coarse * model.coarse_rest;
  push->clearances.setConstant(samples.size(), bones.size(), options.clearance);
  for (size_t b = 0; b < bones.size(); ++b) {
    DistanceField::Value value;
    for (Eigen::Index v = 0; v < rest.rows(); ++v) {
      if (bones[b].field->IsBelow(options.clearance, rest.row(v), &value)) {
        push->clearances(v, b) = value.distance;
      }
    }
  }
  push->reach = model.normal_matrix
                    .solve(Eigen::MatrixXd(push->fine_from_coarse.transpose()))
                    .transpose();
  push->response = push->fine_from_coarse * push->reach.transpose();
  push->stiffness =
      options.relative_stiffness / push->response.diagonal().mean();
  return push;
}

std::vector<Points> FollowPush(const BonePush& push,
                               const std::vector<ScenePose>& way,
                               const std::vector<Points>& free) {
  const Eigen::Index count = push.fine_from_coarse.rows();
  const auto last = static_cast<int>(way.size()) - 1;
  const int steps = push.options.steps_per_pose;
  const double drag = push.options.drag;
  std::vector<Points> places;
  for (const Points& coarse : free) {
    places.push_back(ThinProduct(push.fine_from_coarse, coarse));
  }
  std::vector<Points> displacements = {Points::Zero(free[0].rows(), 3)};
  Push now = {Points::Zero(count, 3), Points::Zero(count, 3)};
  BoneTouches near(push);
  for (int k = 1; k <= last; ++k) {
    const std::vector<ScrewMotion> motions =
        MotionsBetween(push, way[k - 1], way[k]);
    for (int j = 1; j < steps; ++j) {
      const double part = static_cast<double>(j) / steps;
      Settle(push,
             &near,
             PartOf(push, way[k - 1], motions, part),
             PlacesAt(places, k, part),
             drag,
             kRounds,
             &now);
    }
    Settle(push, &near, way[k], places[k], drag, kRounds, &now);
    displacements.push_back(ThinTransposedProduct(push.reach, now.forces));
  }
  displacements.back() = ThinTransposedProduct(
      push.reach, NearLeast(push, &near, way[last], places[last], now).forces);
  return displacements;
}

}  // namespace musclewarp
