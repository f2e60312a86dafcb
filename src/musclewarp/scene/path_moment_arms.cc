// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/path_moment_arms.h"

#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {

std::vector<double> PathLengthsIn(const ScenePose& pose,
                                  const std::vector<ActionLine>& lines) {
  const std::vector<LineTarget> targets = LineTargets(lines, pose);
  std::vector<double> lengths;
  for (size_t k = 0; k < lines.size(); ++k) {
    const auto known = pose.path_lengths.find(lines[k].name);
    lengths.push_back(known != pose.path_lengths.end()
                          ? known->second
                          : PolylineLength(targets[k].points));
  }
  return lengths;
}

std::map<std::string, std::map<std::string, double>> PathMomentArms(
    const Scene& scene,
    const ScenePose& pose,
    const std::vector<PerturbedPoses>& beside) {
  std::map<std::string, std::map<std::string, double>> arms;
  for (const PerturbedPoses& poses : beside) {
    for (const SceneMuscle& muscle : scene.muscles) {
      const std::vector<double> before =
          PathLengthsIn(poses.before, muscle.lines);
      const std::vector<double> after =
          PathLengthsIn(poses.after, muscle.lines);
      for (size_t k = 0; k < muscle.lines.size(); ++k) {
        const std::string& line = muscle.lines[k].name;
        // The lengths of muscle paths account for conditional points.
        arms[line][poses.name] =
            pose.path_lengths.count(line) > 0
                ? PathMomentArm(
                      scene.model->model,
                      scene.model->model
                          .muscles[scene.model->model.FindMuscle(line)],
                      poses.coordinate,
                      pose.model_values) /
                      scene.model->body_size
                : -(after[k] - before[k]) / (2 * PerturbedPoses::kStep);
      }
    }
  }
  return arms;
}

}  // namespace musclewarp
