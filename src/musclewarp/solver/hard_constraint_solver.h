// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// A constraint c(x) = 0 that a Ceres problem carries as one residual
//
//   r = sqrt(penalty) (c(x) + multiplier / penalty),
//
// the augmented Lagrangian multiplier * c + penalty / 2 c^2 up to a constant.
// The residual block reads penalty and multiplier at every evaluation; the
// driver below changes them between solves.
struct HardConstraint {
  double penalty = 1;
  double multiplier = 0;
};

struct HardConstraintOptions {
  // The penalty starts soft and is hardened by the factor, up to the largest,
  // after every round that did not reduce the violation to a quarter. A penalty
  // that is hard from the start stalls: steps must then follow the curved
  // surface c = 0.
  double initial_penalty = 1e3;
  double penalty_factor = 10;
  double max_penalty = 1e6;

  // Done when |c| and the change of the parameters in a round (max norm) are
  // below these. Both in the unit of c and of the parameters; mm in musclewarp.
  double violation_tolerance = 1e-7;
  double step_tolerance = 1e-5;
  int max_rounds = 40;

  // How each round is solved. Tight tolerances: a round must converge for its
  // multiplier update to be worth something.
  ceres::Solver::Options ceres;

  HardConstraintOptions();
  bool IsValid(std::string* error) const;
};

// Minimises `problem` (whose residuals include that of `constraint`) over
// `parameters` (`size` doubles, all parameter blocks of the problem) by the
// method of multipliers: solve, multiplier += penalty * c, harden, repeat.
// `violation` gives c at the current parameters. Fills everything of the
// summary but energies and volume, which it does not know.
void SolveWithHardConstraint(const HardConstraintOptions& options,
                             const std::function<double()>& violation,
                             double* parameters,
                             int size,
                             ceres::Problem* problem,
                             HardConstraint* constraint,
                             SolverSummary* summary);

}  // namespace musclewarp
