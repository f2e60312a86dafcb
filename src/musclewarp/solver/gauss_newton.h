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
  // The step length alpha of each iteration before polishing.
  StepLengthSchedule step_length;

  // The volume error is that of the coarse mesh until every |h_i| is below
  // fine_volume_threshold, mm, or max_coarse_iterations have passed; from then
  // on it is that of the fine mesh. With max_coarse_iterations = 0 the fine
  // mesh is used throughout.
  double fine_volume_threshold = 0.05;
  int max_coarse_iterations = 100;

  // Without polishing, the solver stops when the largest move of a coarse
  // vertex in an iteration, mm, and the relative volume error of the fine mesh
  // are below these two.
  double step_threshold = 5e-3;
  double volume_tolerance = 1e-8;

  // The solver gives up after this many iterations, polishing included.
  int max_iterations = 500;

  // Beyond the paper. A damped step reduces the distance to the minimum by the
  // factor 1 - alpha only, whereas full steps converge much faster once they
  // are near. Polishing therefore takes full steps (alpha = 1) on the fine
  // volume as soon as the largest move falls below polish_start, mm, and ends
  // when it falls below polish_threshold, mm. With polish_threshold = 0 there
  // is no polishing, which is the paper to the letter.
  double polish_start = 0.05;
  double polish_threshold = 1e-4;

  // Returns false and names the field, its value and the rule if a field, one
  // of step_length included, is out of range.
  bool IsValid(std::string* error) const;
};

// Deforms one muscle with the paper's own method, which is the reference that
// the Ceres formulations are tested against: it minimises the linear energy
// 1/2 |f(X)|^2 subject to V(W X) = V_hat by damped Gauss-Newton steps with a
// Lagrange multiplier (paper eq. 2.8 to 2.10, gauss_newton_step.h). One-sided
// rows of the target are part of the energy.
//
// `coarse` (N x 3, mm) is the start on entry and the result on return; the
// result does not depend on the start beyond the thresholds. `summary` says
// whether the solver converged; nothing is thrown.
// Preconditions (CHECKed): the options are valid, `coarse` has a row for each
// coarse vertex of the model.
void SolveGaussNewton(const MuscleModel& model,
                      const MuscleTarget& target,
                      const GaussNewtonOptions& options,
                      Points* coarse,
                      SolverSummary* summary);

}  // namespace musclewarp
