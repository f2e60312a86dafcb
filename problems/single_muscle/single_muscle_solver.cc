// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/single_muscle_solver.h"

#include <glog/logging.h>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/solver/volume_constraint.h"
#include "problems/single_muscle/single_muscle_problem.h"
#include "problems/single_muscle/whitening.h"

namespace musclewarp {
namespace {

void SolveInBlocks(const MuscleModel& model,
                   const MuscleTarget& target,
                   const SingleMuscleOptions& options,
                   Points* coarse,
                   SolverSummary* summary) {
  HardConstraint constraint;
  ceres::Problem problem;
  AddMuscleInBlocks(model, target, constraint, coarse, &problem);
  SolveWithHardConstraint(
      options.hard_constraint,
      [&] { return FineVolumeError(model, *coarse) / model.rest_area; },
      coarse->data(),
      coarse->size(),
      &problem,
      &constraint,
      summary);
}

void SolveWhitened(const MuscleModel& model,
                   const MuscleTarget& target,
                   const SingleMuscleOptions& options,
                   Points* coarse,
                   SolverSummary* summary) {
  const Whitening whitening(model, target);
  Points whitened = whitening.WhitenedFromCoarse(*coarse);
  HardConstraint constraint;
  ceres::Problem problem;
  AddMuscleWhitened(model, whitening, constraint, &whitened, &problem);
  SolveWithHardConstraint(
      options.hard_constraint,
      [&] {
        return FineVolumeError(model, whitening.CoarseFromWhitened(whitened)) /
               model.rest_area;
      },
      whitened.data(),
      whitened.size(),
      &problem,
      &constraint,
      summary);
  *coarse = whitening.CoarseFromWhitened(whitened);
}

}  // namespace

SingleMuscleOptions SingleMuscleOptions::For(MuscleFormulation formulation) {
  SingleMuscleOptions options;
  options.formulation = formulation;
  if (formulation == MuscleFormulation::kBlocks) {
    options.hard_constraint.ceres.linear_solver_type =
        ceres::DENSE_NORMAL_CHOLESKY;
    options.hard_constraint.ceres.preconditioner_type = ceres::JACOBI;
  }
  return options;
}

bool SingleMuscleOptions::IsValid(std::string* error) const {
  return hard_constraint.IsValid(error);
}

void SolveSingleMuscle(const MuscleModel& model,
                       const MuscleTarget& target,
                       const SingleMuscleOptions& options,
                       Points* coarse,
                       SolverSummary* summary) {
  const Stopwatch stopwatch;
  CHECK_EQ(coarse->rows(), model.coarse_rest.rows());
  const double initial_energy = LinearEnergy(model, target, *coarse);
  if (options.formulation == MuscleFormulation::kWhitened) {
    SolveWhitened(model, target, options, coarse, summary);
  } else {
    SolveInBlocks(model, target, options, coarse, summary);
  }
  summary->initial_energy = initial_energy;
  SummarizeSolution(model, target, *coarse, summary);
  summary->wall_ms = stopwatch.Milliseconds();
}

}  // namespace musclewarp
