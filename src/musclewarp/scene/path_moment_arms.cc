// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/path_moment_arms.h"

#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

// rad or m, see PathMomentArm.
constexpr double kStep = 1e-4;

ScenePose PoseBeside(const ModelPoses& poses,
                     const ScenePose& pose,
                     int coordinate,
                     double step) {
  CoordinateValues values = pose.model_values;
  values[coordinate] += step;
  ApplyCouplers(poses.model, &values);
  return PoseAt(poses, values);
}

}  // namespace

double PathLengthIn(const ScenePose& pose, const ActionLine& line) {
  const auto known = pose.path_lengths.find(line.name);
  if (known != pose.path_lengths.end()) return known->second;
  return PolylineLength(LineTargets({line}, pose)[0].points);
}

std::map<std::string, std::map<std::string, double>> PathMomentArms(
    const Scene& scene, const ScenePose& pose) {
  std::map<std::string, std::map<std::string, double>> arms;
  if (!scene.model) return arms;
  const ModelPoses& poses = *scene.model;
  for (const int coordinate : poses.moving_coordinates) {
    const std::string& name = poses.model.coordinates[coordinate].name;
    const ScenePose before = PoseBeside(poses, pose, coordinate, -kStep);
    const ScenePose after = PoseBeside(poses, pose, coordinate, kStep);
    for (const SceneMuscle& muscle : scene.muscles) {
      for (const ActionLine& line : muscle.lines) {
        // Paths of muscles know where their conditional points switch.
        arms[line.name][name] =
            pose.path_lengths.count(line.name)
                ? PathMomentArm(
                      poses.model,
                      poses.model.muscles[poses.model.FindMuscle(line.name)],
                      coordinate,
                      pose.model_values)
                : -(PathLengthIn(after, line) - PathLengthIn(before, line)) /
                      (2 * kStep);
      }
    }
  }
  return arms;
}

}  // namespace musclewarp
