// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/path_moment_arms.h"

#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {

double PathLengthIn(const ScenePose& pose, const ActionLine& line) {
  const auto known = pose.path_lengths.find(line.name);
  if (known != pose.path_lengths.end()) return known->second;
  return PolylineLength(LineTargets({line}, pose)[0].points);
}

std::map<std::string, std::map<std::string, double>> PathMomentArms(
    const Scene& scene,
    const ScenePose& pose,
    const std::vector<PerturbedPoses>& beside) {
  std::map<std::string, std::map<std::string, double>> arms;
  for (const SceneMuscle& muscle : scene.muscles) {
    for (const ActionLine& line : muscle.lines) {
      // The lengths of muscle paths account for conditional points.
      const bool is_path = pose.path_lengths.count(line.name) > 0;
      for (const PerturbedPoses& poses : beside) {
        arms[line.name][poses.name] =
            is_path
                ? PathMomentArm(
                      scene.model->model,
                      scene.model->model
                          .muscles[scene.model->model.FindMuscle(line.name)],
                      poses.coordinate,
                      pose.model_values) /
                      scene.model->body_size
                : -(PathLengthIn(poses.after, line) -
                    PathLengthIn(poses.before, line)) /
                      (2 * PerturbedPoses::kStep);
      }
    }
  }
  return arms;
}

}  // namespace musclewarp
