// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/solver_summary.h"
#include "musclewarp/solver/step_length.h"

namespace musclewarp {

struct GaussNewtonOptions {
  StepLengthSchedule step_length;

  // The volume error is taken from the coarse mesh until every |h_i| is below
  // this, mm, or that many iterations have passed; then from the fine mesh.
  double fine_volume_threshold = 0.05;
  int max_coarse_iterations = 100;

  // Stop when the largest move of a coarse vertex, mm, and the relative volume
  // error of the fine mesh are below these.
  double step_threshold = 5e-3;
  double volume_tolerance = 1e-8;

  int max_iterations = 500;

  // Beyond the paper: damped steps approach the minimum by a factor 1 - alpha
  // each, full steps much faster once they are near. So steps with alpha = 1
  // take over on the fine volume when the move falls below polish_start, mm,
  // and stop below polish_threshold. 0 leaves them out, and the result as the
  // paper has it.
  double polish_start = 0.05;
  double polish_threshold = 1e-4;

  bool IsValid(std::string* error) const;
};

// The reference solver: Gauss-Newton with Lagrange multiplier, steps as in
// gauss_newton_step.h. `coarse` (N x 3) is the start and the result.
// Precondition (CHECKed): the options are valid.
void SolveGaussNewton(const MuscleModel& model,
                      const MuscleTarget& target,
                      const GaussNewtonOptions& options,
                      Points* coarse,
                      SolverSummary* summary);

}  // namespace musclewarp
