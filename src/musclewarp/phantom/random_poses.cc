// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/random_poses.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "musclewarp/phantom/scene_parts.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp::phantom {
namespace {

using Eigen::Vector3d;

constexpr double kLargestTurn = 60;  // degrees

// A turn of a bone against its parent, about an axis through the joint.
struct JointTurn {
  int bone = 0;
  Vector3d axis;
  double degrees = 0;
};

// Returns target_from_rest of every bone at a share (0 to 1) of the turns.
std::vector<Eigen::Matrix4d> Transforms(const std::vector<RandomBone>& bones,
                                        const std::vector<JointTurn>& turns,
                                        double share) {
  std::vector<Eigen::Matrix4d> all;
  for (size_t i = 0; i < bones.size(); ++i) {
    Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
    if (bones[i].parent >= 0) transform = all[bones[i].parent];
    for (const JointTurn& turn : turns) {
      if (turn.bone != static_cast<int>(i)) continue;
      transform *=
          RotationAbout(bones[i].joint, turn.axis, share * turn.degrees);
    }
    // Rounded as RotationAbout does.
    all.push_back((transform.array() * 1e12).round() / 1e12 + 0.0);
  }
  return all;
}

std::map<std::string, Eigen::Matrix4d> ByBody(
    const std::vector<RandomBone>& bones,
    const std::vector<Eigen::Matrix4d>& transforms) {
  std::map<std::string, Eigen::Matrix4d> bodies;
  for (size_t i = 0; i < bones.size(); ++i) {
    bodies[bones[i].name] = transforms[i];
  }
  return bodies;
}

// True if the line goes where a muscle can follow it.
bool CanFollow(const ActionLine& line,
               const std::vector<RandomBone>& bones,
               const std::vector<Eigen::Matrix4d>& transforms) {
  constexpr double kLeastRatio = 0.6;
  constexpr double kLargestRatio = 1.5;
  constexpr double kDeepest = 6;  // mm
  constexpr double kSharpestTurn = 0.5 * 3.14159265358979323846;
  ScenePose pose;
  pose.bodies = ByBody(bones, transforms);
  const Points moved = LineTargets({line}, pose)[0].points;
  const double ratio = PolylineLength(moved) / PolylineLength(line.rest);
  if (ratio < kLeastRatio || ratio > kLargestRatio) return false;
  if (SharpestTurn(moved) > kSharpestTurn) return false;
  for (size_t b = 0; b < bones.size(); ++b) {
    const Eigen::Matrix4d rest_from_target = transforms[b].inverse();
    for (Eigen::Index i = 0; i < moved.rows(); ++i) {
      const Eigen::Vector4d p = moved.row(i).transpose().homogeneous().eval();
      if (bones[b].field((rest_from_target * p).head<3>()) < -kDeepest) {
        return false;
      }
    }
  }
  return true;
}

bool IsPossible(const std::vector<RandomBone>& bones,
                const std::vector<RandomMuscle>& muscles,
                const std::vector<JointTurn>& turns) {
  constexpr double kLeastBoneGap = 0.5;  // mm between bones
  constexpr int kSteps = 6;
  for (int step = kSteps; step > 0; --step) {
    const std::vector<Eigen::Matrix4d> transforms =
        Transforms(bones, turns, step / static_cast<double>(kSteps));
    for (const RandomMuscle& muscle : muscles) {
      for (const ActionLine& line : muscle.lines) {
        if (!CanFollow(line, bones, transforms)) return false;
      }
    }
    if (LeastBoneDistance(bones, transforms) < kLeastBoneGap) return false;
  }
  return true;
}

// Draws a turn that moves an end of a drawn muscle.
JointTurn DrawTurn(const std::vector<RandomBone>& bones,
                   const std::vector<RandomMuscle>& muscles,
                   RandomDraws* draws) {
  JointTurn turn;
  const int last = static_cast<int>(muscles.size()) - 1;
  const RandomMuscle& muscle = muscles[draws->Integer(0, last)];
  // Parents come before their children: the later bone is not the root.
  turn.bone = std::max({muscle.ends[0].bone, muscle.ends[1].bone, 1});
  const RandomBone& bone = bones[turn.bone];
  turn.axis = draws->DirectionAcross(bone.axis);
  turn.degrees = draws->Uniform(25, kLargestTurn);
  if (bone.is_beside_parent) {
    turn.axis = (bone.axis + 0.05 * turn.axis).normalized();
  } else if (draws->Chance(0.25)) {
    turn.axis = draws->Direction();
  }
  return turn;
}

// Reduces the angle of the last turn until the motion is possible. Returns
// false if it is not at the least angle either.
bool FitLastTurn(const std::vector<RandomBone>& bones,
                 const std::vector<RandomMuscle>& muscles,
                 std::vector<JointTurn>* turns) {
  constexpr double kLeastTurn = 8;  // degrees
  double& degrees = turns->back().degrees;
  for (; degrees >= kLeastTurn; degrees *= 0.7) {
    if (IsPossible(bones, muscles, *turns)) return true;
  }
  return false;
}

}  // namespace

std::vector<ScenePose> DrawPoses(const std::vector<RandomBone>& bones,
                                 const std::vector<RandomMuscle>& muscles,
                                 RandomDraws* draws,
                                 int num_poses) {
  constexpr int kAttempts = 12;
  const size_t count = draws->Chance(0.5) ? 1 : 2;
  const int drawn = draws->Integer(3, 5);
  const int poses = num_poses == 0 ? drawn : num_poses;
  std::vector<JointTurn> turns;
  for (int i = 0; i < kAttempts && turns.size() < count; ++i) {
    turns.push_back(DrawTurn(bones, muscles, draws));
    for (size_t j = 0; j + 1 < turns.size(); ++j) {
      // Two turns of a joint share the largest angle.
      if (turns[j].bone != turns.back().bone) continue;
      turns.back().degrees =
          std::min(turns.back().degrees, kLargestTurn - turns[j].degrees);
    }
    if (!FitLastTurn(bones, muscles, &turns)) turns.pop_back();
  }
  std::vector<ScenePose> motion;
  if (turns.empty()) return motion;
  for (int i = 0; i < poses; ++i) {
    ScenePose pose;
    pose.name = "step_" + std::to_string(i);
    pose.time = i;
    const double share = poses == 1 ? 1 : i / (poses - 1.0);
    pose.bodies = ByBody(bones, Transforms(bones, turns, share));
    motion.push_back(pose);
  }
  return motion;
}

}  // namespace musclewarp::phantom
