// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/moment_arms.h"

#include <glog/logging.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/frames/plane_rates.h"
#include "musclewarp/geometry/fine_map.h"
#include "musclewarp/geometry/thin_product.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/preparation/soft_attachments.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/scene/moved_pose.h"
#include "musclewarp/scene/path_moment_arms.h"
#include "musclewarp/scene/perturbed_poses.h"
#include "musclewarp/solver/bone_push_rates.h"
#include "musclewarp/solver/shape_derivative.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;

bool IsSamePlace(const Matrix4d& a, const Matrix4d& b) {
  const Matrix4d difference = (a - b).cwiseAbs();
  return difference.leftCols<3>().maxCoeff() < 1e-12 &&
         difference.rightCols<1>().maxCoeff() < 1e-9;  // mm
}

// Whether two poses ask the same of a muscle, to rounding: its lines and all
// bodies on which it depends are at the same places.
bool AskTheSame(const ScenePose& a,
                const ScenePose& b,
                const MuscleModel& model) {
  for (const ActionLine& line : model.lines) {
    const auto in_a = a.lines.find(line.name), in_b = b.lines.find(line.name);
    if ((in_a == a.lines.end()) != (in_b == b.lines.end())) return false;
    if (in_a != a.lines.end() &&
        !((in_a->second - in_b->second).cwiseAbs().maxCoeff() < 1e-9)) {
      return false;
    }
    for (const std::string& body : line.bodies) {
      if (!IsSamePlace(BodyTransform(a, body), BodyTransform(b, body))) {
        return false;
      }
    }
  }
  for (int k = 0; k < static_cast<int>(model.attachments.size()); ++k) {
    if (!IsSamePlace(AttachmentTransform(model, k, a),
                     AttachmentTransform(model, k, b))) {
      return false;
    }
  }
  return true;
}

// The rate of a target that stands still.
MuscleTarget ZeroRate(const MuscleTarget& target) {
  MuscleTarget rate;
  rate.laplacian = Points::Zero(target.laplacian.rows(), 3);
  rate.skeleton = Points::Zero(target.skeleton.rows(), 3);
  rate.attachment = Points::Zero(target.attachment.rows(), 3);
  rate.bending = Points::Zero(target.bending.rows(), 3);
  return rate;
}

MuscleTarget Difference(const MuscleTarget& before, const MuscleTarget& after) {
  MuscleTarget rate;
  constexpr double kWay = 2 * PerturbedPoses::kStep;
  rate.laplacian = (after.laplacian - before.laplacian) / kWay;
  rate.skeleton = (after.skeleton - before.skeleton) / kWay;
  rate.attachment = (after.attachment - before.attachment) / kWay;
  rate.bending = (after.bending - before.bending) / kWay;
  return rate;
}

// Returns minus the derivatives of the lengths of carried lines, which move
// linearly with the derivative `rate` of the shape that carries them.
std::vector<double> MomentArmsOf(const EmbeddedLines& carried,
                                 const std::vector<Points>& lines,
                                 const Points& rate) {
  std::vector<double> arms;
  if (rate.isZero(0)) {
    arms.resize(lines.size(), 0);
    return arms;
  }
  const std::vector<Points> velocities = LinesAt(carried, rate);
  for (size_t k = 0; k < lines.size(); ++k) {
    double arm = 0;
    for (Eigen::Index i = 1; i < lines[k].rows(); ++i) {
      const Eigen::RowVector3d edge = lines[k].row(i) - lines[k].row(i - 1);
      // An edge without length has no direction to lengthen in.
      if (edge.squaredNorm() == 0) continue;
      arm -= edge.normalized().dot(velocities[k].row(i) -
                                   velocities[k].row(i - 1));
    }
    arms.push_back(arm);
  }
  return arms;
}

// The names of the soft parts to which muscles are attached.
std::set<std::string> NamesOfCarriers(const PreparedScene& scene) {
  std::set<std::string> names;
  for (const PreparedMuscle& muscle : scene.muscles) {
    for (const auto& carrier : muscle.model.carriers) {
      names.insert(carrier.second.muscle);
    }
  }
  return names;
}

// The moment arms of a scene, step by step.
//
// Each muscle is seen from a body of its own, so that a coordinate that moves
// all that it depends on as one has no part in it, to rounding.
class MomentArms {
 public:
  MomentArms(const PreparedScene& scene,
             const ScenePose& pose,
             const PreRotationOptions& pre_rotation,
             const ConvergedShapes& shapes,
             std::vector<PerturbedPoses> beside,
             Frame* frame)
      : scene_(scene),
        pose_(pose),
        pre_rotation_(pre_rotation),
        shapes_(shapes),
        beside_(std::move(beside)),
        frame_(*frame),
        muscles_(scene.muscles.size()) {}

  void Add() {
    FindCarriers();
    const int count = static_cast<int>(muscles_.size());
    const std::set<std::string> carriers = NamesOfCarriers(scene_);
    for (const std::vector<int>& group : CarriersFirst(scene_)) {
      ParallelFor(group.size(), [&](size_t k) { FindRates(group[k]); });
      for (const int i : group) {
        if (carriers.count(scene_.muscles[i].model.name) > 0) SetPushes(i);
      }
    }
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < count; ++i) SolveFree(i);
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < count; ++i) SolveHeld(i);
    for (const Muscle& muscle : muscles_) {
      for (const ShapeRate& rate : muscle.held) {
        frame_.moment_arms_converged &= rate.is_converged;
      }
    }
  }

 private:
  struct Muscle {
    bool carries_planes = false;
    MuscleTarget target;
    std::vector<Matrix4d> reference;  // by coordinate: the rate of its body
    std::vector<TargetRate> rates;    // by coordinate, as that body sees it
    std::vector<Points> push_rates;   // of which `rates` takes account
    std::vector<ShapeRate> free, held;
  };

  bool HasRows(int i) const {
    return !shapes_.contact.empty() && shapes_.contact[i].rows.size() > 0;
  }

  // Marks the muscles with which planes of active rows go along.
  void FindCarriers() {
    for (const ContactRows& contact : shapes_.contact) {
      for (const PlaneOwner& owner : contact.owners) {
        if (owner.IsBone()) continue;
        muscles_[owner.muscle_above].carries_planes = true;
        muscles_[owner.muscle_below].carries_planes = true;
      }
    }
  }

  // The body from which a muscle is seen; none if it has a line that no body
  // carries, as such a line does not tell how it turns.
  std::string BodyOf(const MuscleModel& model) const {
    for (const ActionLine& line : model.lines) {
      if (line.bodies.empty()) return "";
    }
    return model.lines[0].bodies[0];
  }

  void FindRates(int i) {
    const MuscleModel& model = scene_.muscles[i].model;
    Muscle& muscle = muscles_[i];
    muscle.target = TargetOf(model, pose_, pre_rotation_);
    const std::string body = BodyOf(model);
    const Matrix4d here = BodyTransform(pose_, body);
    for (const PerturbedPoses& poses : beside_) {
      const Matrix4d before = BodyTransform(poses.before, body);
      const Matrix4d after = BodyTransform(poses.after, body);
      muscle.reference.push_back(RateBetween(before, after));
      const ScenePose seen_before =
          MovedPose(poses.before, here * RigidInverse(before));
      const ScenePose seen_after =
          MovedPose(poses.after, here * RigidInverse(after));
      TargetRate& rate = muscle.rates.emplace_back();
      rate.linear =
          AskTheSame(seen_before, seen_after, model)
              ? ZeroRate(muscle.target)
              : Difference(TargetOf(model, seen_before, pre_rotation_),
                           TargetOf(model, seen_after, pre_rotation_));
    }
    AddPushRates(i);
  }

  // How the bodies of the bones that push a muscle move with a coordinate, as
  // the body of the muscle sees it.
  std::vector<Matrix4d> PushingBodies(int i, size_t c) const {
    std::vector<Matrix4d> bodies;
    for (const BoneField& body : scene_.muscles[i].model.bone_push->bones) {
      bodies.push_back(RateBetween(BodyTransform(beside_[c].before, body.body),
                                   BodyTransform(beside_[c].after, body.body)) -
                       muscles_[i].reference[c]);
    }
    return bodies;
  }

  // Adds how the push of bones on a muscle changes.
  void AddPushRates(int i) {
    const MuscleModel& model = scene_.muscles[i].model;
    Muscle& muscle = muscles_[i];
    const auto push = pose_.pushes.find(model.name);
    if (push == pose_.pushes.end()) return;
    const Points zero = Points::Zero(push->second.rows(), 3);
    std::vector<PushMotion> motions;
    for (size_t c = 0; c < beside_.size(); ++c) {
      motions.push_back({model.normal_matrix.solve(LinearDescent(
                             model, muscle.rates[c].linear, zero)),
                         PushingBodies(i, c)});
    }
    muscle.push_rates =
        PushRates(*model.bone_push,
                  pose_,
                  UnconstrainedMinimizer(model, muscle.target) - push->second,
                  push->second,
                  motions);
    for (size_t c = 0; c < beside_.size(); ++c) {
      AddRowsOf(model, muscle.push_rates[c], &muscle.rates[c].linear);
    }
  }

  // Sets the push on a muscle in the poses beside, for what goes along with it.
  void SetPushes(int i) {
    const MuscleModel& model = scene_.muscles[i].model;
    const std::string body = BodyOf(model);
    const Matrix4d back = RigidInverse(BodyTransform(pose_, body));
    for (size_t c = 0; c < muscles_[i].push_rates.size(); ++c) {
      for (const double side : {-1.0, 1.0}) {
        ScenePose& there = side < 0 ? beside_[c].before : beside_[c].after;
        const Eigen::Matrix3d turn =
            (BodyTransform(there, body) * back).topLeftCorner<3, 3>();
        there.pushes[model.name] =
            (pose_.pushes.at(model.name) +
             side * PerturbedPoses::kStep * muscles_[i].push_rates[c]) *
            turn.transpose();
      }
    }
  }

  // Finds how a muscle moves without contact, if planes go along with it.
  void SolveFree(int i) {
    Muscle& muscle = muscles_[i];
    if (!muscle.carries_planes) return;
    const MuscleModel& model = scene_.muscles[i].model;
    const Points& coarse = shapes_.free_coarse[i];
    muscle.free = DifferentiateShape(model,
                                     muscle.target,
                                     coarse,
                                     Product(model.fine_from_coarse, coarse),
                                     muscle.rates);
  }

  // How what carries planes moves with a coordinate, as the body of a muscle
  // sees it.
  CarrierRates CarriersSeenFrom(int i, size_t c) const {
    const Matrix4d& reference = muscles_[i].reference[c];
    CarrierRates owners;
    for (const PreparedBone& bone : scene_.bones) {
      owners.bones.push_back(
          RateBetween(BodyTransform(beside_[c].before, bone.body),
                      BodyTransform(beside_[c].after, bone.body)) -
          reference);
    }
    for (size_t j = 0; j < muscles_.size(); ++j) {
      MuscleCarrier& owner = owners.muscles.emplace_back();
      if (!muscles_[j].carries_planes) continue;
      owner.points = &frame_.muscles[j].points;
      owner.rate = &muscles_[j].free[c].fine;
      owner.body = muscles_[j].reference[c] - reference;
    }
    return owners;
  }

  void SolveHeld(int i) {
    const PreparedMuscle& prepared = scene_.muscles[i];
    const Points& coarse = shapes_.muscles.coarse[i];
    Muscle& muscle = muscles_[i];
    if (HasRows(i)) {
      const OneSidedRows& rows = shapes_.contact[i].rows;
      const Points places =
          ThinProduct(FineFromCoarse(prepared.model, rows), coarse);
      muscle.target.one_sided = rows;
      for (size_t c = 0; c < beside_.size(); ++c) {
        AddPlaneRates(shapes_.contact[i],
                      places,
                      CarriersSeenFrom(i, c),
                      &muscle.rates[c]);
      }
    }
    muscle.held = HasRows(i) || muscle.free.empty()
                      ? DifferentiateShape(prepared.model,
                                           muscle.target,
                                           coarse,
                                           shapes_.muscles.fine[i],
                                           muscle.rates)
                      : muscle.free;
    const std::vector<Points> lines = LinesAt(prepared.lines, coarse);
    const std::vector<Points> fibres = LinesAt(prepared.fibres, coarse);
    MuscleFrame& frame = frame_.muscles[i];
    for (size_t c = 0; c < beside_.size(); ++c) {
      const Points& rate = muscle.held[c].coarse;
      const std::string& name = beside_[c].name;
      const auto of_lines = MomentArmsOf(prepared.lines, lines, rate);
      for (size_t k = 0; k < of_lines.size(); ++k) {
        frame.line_moment_arms[prepared.model.lines[k].name][name] =
            of_lines[k];
      }
      auto of_fibres = MomentArmsOf(prepared.fibres, fibres, rate);
      if (std::any_of(of_fibres.begin(), of_fibres.end(), [](double arm) {
            return arm != 0;
          })) {
        frame.fibre_moment_arms[name] = std::move(of_fibres);
      }
    }
  }

  const PreparedScene& scene_;
  const ScenePose& pose_;
  const PreRotationOptions& pre_rotation_;
  const ConvergedShapes& shapes_;
  std::vector<PerturbedPoses> beside_;
  Frame& frame_;
  std::vector<Muscle> muscles_;
};

// Returns the poses on both sides of a pose, with taut lines moved on by their
// derivatives.
std::vector<PerturbedPoses> PosesBeside(const Scene& scene,
                                        const ScenePose& pose) {
  std::vector<PerturbedPoses> beside = PerturbedPosesOf(*scene.model, pose);
  for (const SceneMuscle& muscle : scene.muscles) {
    SetTautLines(muscle.lines, pose, &beside);
  }
  return beside;
}

}  // namespace

void AddMomentArms(const PreparedScene& scene,
                   const ScenePose& pose,
                   const PreRotationOptions& pre_rotation,
                   const ConvergedShapes& shapes,
                   Frame* frame) {
  if (!scene.scene.model) return;
  const ScopedStage stage("moment arms");
  const Stopwatch watch;
  const std::vector<PerturbedPoses> beside = PosesBeside(scene.scene, pose);
  frame->path_moment_arms = PathMomentArms(scene.scene, pose, beside);
  MomentArms(scene, pose, pre_rotation, shapes, beside, frame).Add();
  frame->moment_arms_ms = watch.Milliseconds();
}

void AddPathMomentArms(const PreparedScene& scene,
                       const ScenePose& pose,
                       Frame* frame) {
  if (!scene.scene.model) return;
  const Stopwatch watch;
  frame->path_moment_arms =
      PathMomentArms(scene.scene, pose, PosesBeside(scene.scene, pose));
  frame->moment_arms_ms = watch.Milliseconds();
}

}  // namespace musclewarp
