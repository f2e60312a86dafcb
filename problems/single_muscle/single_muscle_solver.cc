// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/single_muscle_solver.h"

#include <glog/logging.h>

#include "musclewarp/base/invalid_option.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/solver/first_step.h"
#include "musclewarp/solver/volume_constraint.h"
#include "problems/single_muscle/single_muscle_problem.h"

namespace musclewarp {
namespace {

Eigen::VectorXd Flattened(const Points& points) {
  return Eigen::Map<const Eigen::VectorXd>(points.data(), points.size());
}

}  // namespace

SingleMuscleOptions SingleMuscleOptions::For(MuscleFormulation formulation) {
  SingleMuscleOptions options;
  options.formulation = formulation;
  if (formulation == MuscleFormulation::kBlocks) {
    options.hard_constraint.ceres.linear_solver_type =
        ceres::DENSE_NORMAL_CHOLESKY;
    options.hard_constraint.ceres.preconditioner_type = ceres::JACOBI;
    options.hard_constraint.ceres.jacobi_scaling = true;
  }
  return options;
}

bool SingleMuscleOptions::IsValid(std::string* error) const {
  if (!(fine_volume_threshold > 0)) {
    return InvalidOption("SingleMuscleOptions::fine_volume_threshold",
                         fine_volume_threshold,
                         "above 0",
                         error);
  }
  return hard_constraint.IsValid(error);
}

void SolveSingleMuscle(const MuscleModel& model,
                       const MuscleTarget& target,
                       const SingleMuscleOptions& options,
                       Points* coarse,
                       SolverSummary* summary) {
  const Stopwatch stopwatch;
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK_EQ(coarse->rows(), model.coarse_rest.rows());
  MuscleUnknowns unknowns(model, target, options.formulation, *coarse);
  HardConstraint constraint;
  constraint.penalty = options.hard_constraint.initial_penalty;
  ceres::Problem problem;
  VolumeEvaluator volume(model, nullptr);
  volume.ReuseGradientWithin(10 * options.hard_constraint.step_tolerance);
  AddMuscle(model, target, constraint, &volume, &unknowns, &problem);
  const auto solve = [&](VolumeMesh mesh,
                         const HardConstraintOptions& hard_constraint) {
    volume.SetMesh(mesh);
    SolverSummary part;
    SolveWithHardConstraint(
        hard_constraint,
        [&] { return volume.Error(unknowns.Coarse()) / model.rest_area; },
        [&] { return Flattened(unknowns.Coarse()); },
        &problem,
        &constraint,
        &part);
    for (SolverIteration& iteration : part.history) {
      iteration.volume_error *= model.rest_area / model.rest_volume;
      iteration.is_fine_volume = mesh == VolumeMesh::kFine;
    }
    return part;
  };
  const auto first_step = [&] {
    volume.SetMesh(VolumeMesh::kFine);
    const FirstStep first =
        FirstStepFrom(model, target, unknowns.Coarse(), &volume);
    constraint.multiplier = first.multiplier * model.rest_area;
    return first.length;
  };
  SolverSummary approach;
  approach.iterations = 0;
  if (first_step() > options.fine_volume_threshold) {
    // As in the paper, the volume of the coarse mesh, which costs next to
    // nothing, brings the muscle close to the solution.
    HardConstraintOptions near = options.hard_constraint;
    near.violation_tolerance = near.step_tolerance =
        options.fine_volume_threshold;
    approach = solve(VolumeMesh::kCoarse, near);
    first_step();
  }
  *summary = MergedSummary(approach,
                           solve(VolumeMesh::kFine, options.hard_constraint));
  summary->initial_energy = LinearEnergy(model, target, *coarse);
  *coarse = unknowns.Coarse();
  summary->final_energy = LinearEnergy(model, target, *coarse);
  summary->volume_ratio = 1 + volume.Error(*coarse) / model.rest_volume;
  summary->wall_ms = stopwatch.Milliseconds();
}

}  // namespace musclewarp
