// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/contact_step.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <utility>

#include "musclewarp/base/stage_times.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Returns the rotation of a triangle from `a` to `b`, a matrix for row vectors.
Eigen::Matrix3d RotationBetween(const Corners& a, const Corners& b) {
  const auto frame = [](const Corners& t) {
    Eigen::Matrix3d axes;
    const RowVector3d e = (t.row(1) - t.row(0)).normalized();
    const RowVector3d n =
        e.cross(RowVector3d(t.row(2) - t.row(0))).normalized();
    axes << e, n, e.cross(n);
    return axes;
  };
  return frame(a).transpose() * frame(b);
}

}  // namespace

ContactStep MakeContactStep(const ContactScene& scene,
                            const ContactState& before,
                            const std::vector<Points>& targets,
                            std::vector<Eigen::Matrix4d> bones_from_rest,
                            std::vector<AttachedPoints> attached,
                            std::vector<char> is_still) {
  const ScopedStage stage("start of a step");
  CHECK_EQ(before.points.size(), scene.muscles.size());
  CHECK_EQ(before.targets.size(), scene.muscles.size());
  CHECK_EQ(targets.size(), scene.muscles.size());
  CHECK_EQ(before.bones_from_rest.size(), scene.bones.size());
  CHECK_EQ(bones_from_rest.size(), scene.bones.size());
  attached.resize(scene.muscles.size());
  is_still.resize(scene.muscles.size(), false);
  ContactStep step{scene,
                   before,
                   std::move(bones_from_rest),
                   std::move(attached),
                   {},
                   std::move(is_still),
                   {},
                   {},
                   {}};
  for (const MuscleSurface& muscle : scene.muscles) {
    step.trees_before.push_back(*muscle.tree);
  }
  step.predicted.resize(scene.muscles.size());
  step.rotations.resize(scene.muscles.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < step.num_muscles(); ++i) {
    const Triangles& triangles = scene.muscles[i].triangles;
    step.predicted[i] = before.points[i];
    if (!step.is_still[i]) step.predicted[i] += targets[i] - before.targets[i];
    step.trees_before[i].Refit(before.points[i]);
    step.rotations[i].resize(triangles.rows());
    for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
      step.rotations[i][f] =
          RotationBetween(step.trees_before[i].corners(static_cast<int>(f)),
                          CornersOf(step.predicted[i], triangles.row(f)));
    }
  }
  return step;
}

double ReachOf(const StepOptions& options,
               const ContactStep& step,
               int muscle) {
  return step.reaches.empty() ? options.reach : step.reaches[muscle];
}

std::vector<TriangleBvh> PredictedTrees(const ContactStep& step) {
  std::vector<TriangleBvh> trees = step.trees_before;
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < step.num_muscles(); ++i) {
    trees[i].Refit(step.predicted[i]);
  }
  return trees;
}

}  // namespace musclewarp
