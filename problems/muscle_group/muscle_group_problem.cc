// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/muscle_group/muscle_group_problem.h"

#include <glog/logging.h>

#include "problems/single_muscle/single_muscle_problem.h"

namespace musclewarp {
namespace {

ceres::Problem::Options WithCallback(ceres::EvaluationCallback* callback) {
  ceres::Problem::Options options;
  options.evaluation_callback = callback;
  return options;
}

}  // namespace

MuscleGroupProblem::MuscleGroupProblem(
    const std::vector<const MuscleModel*>& models,
    const std::vector<MuscleTarget>& targets,
    MuscleFormulation formulation,
    const std::vector<MuscleState>& states)
    : prefetch(unknowns, volumes), problem(WithCallback(&prefetch)) {
  CHECK_EQ(models.size(), targets.size());
  CHECK_EQ(models.size(), states.size());
  for (size_t i = 0; i < models.size(); ++i) {
    constraints.push_back(std::make_unique<HardConstraint>());
    volumes.push_back(
        std::make_unique<VolumeEvaluator>(*models[i], &states[i].corrections));
    unknowns.push_back(std::make_unique<MuscleUnknowns>(
        *models[i], targets[i], formulation, states[i].coarse));
    AddMuscle(*models[i],
              targets[i],
              *constraints[i],
              volumes[i].get(),
              unknowns[i].get(),
              &problem);
  }
}

void MuscleGroupProblem::SetStates(const std::vector<MuscleState>& states) {
  for (size_t i = 0; i < unknowns.size(); ++i) {
    unknowns[i]->SetCoarse(states[i].coarse);
    volumes[i]->Forget();
  }
}

void MuscleGroupProblem::SetVolumeMesh(VolumeMesh mesh) {
  for (auto& volume : volumes) volume->SetMesh(mesh);
}

}  // namespace musclewarp
