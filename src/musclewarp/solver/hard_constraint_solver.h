// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

struct HardConstraintOptions;

// A constraint c(x) = target that a Ceres problem carries as one residual
//
//   r = sqrt(penalty) (c(x) - target + multiplier / penalty),
//
// the augmented Lagrangian up to a constant. The residual block reads penalty
// and multiplier at every evaluation; the driver below changes them between
// solves.
struct HardConstraint {
  double penalty = 1;
  double multiplier = 0;
  double target = 0;

  double Residual(double c) const;

  // After a round that ended at the violation c - target: a better multiplier
  // if the violation has fallen to a quarter of the previous one or the round
  // has reached its minimum; a harder penalty if it has not fallen. True if it
  // has.
  bool Update(const HardConstraintOptions& options,
              double violation,
              double previous_violation,
              bool is_minimum);
};

struct HardConstraintOptions {
  // The penalty starts soft and is hardened by the factor, up to the largest,
  // after every round that did not reduce the violation to a quarter. A penalty
  // that is hard from the start stalls: steps must then follow the curved
  // surface c = 0.
  double initial_penalty = 1e3;
  double penalty_factor = 10;
  double max_penalty = 1e6;

  // Done when |c| and the change of the state in a round (max norm) are below
  // these; mm in musclewarp.
  double violation_tolerance = 1e-8;
  double step_tolerance = 1e-5;
  int max_rounds = 100;

  // How each round is solved.
  ceres::Solver::Options ceres;

  HardConstraintOptions();
  bool IsValid(std::string* error) const;
};

// Minimises `problem` (whose residuals include that of `constraint`) by the
// method of multipliers: solve, multiplier += penalty * c, harden, repeat. A
// round is one step of Ceres, more only when the violation does not fall.
// Penalty and multiplier start from what `constraint` has. `violation` gives
// c - target at the current parameters, `state` what steps are measured on.
// Fills everything of the summary but energies and volume, which it does not
// know; the volume errors in the history are violations.
void SolveWithHardConstraint(const HardConstraintOptions& options,
                             const std::function<double()>& violation,
                             const std::function<Eigen::VectorXd()>& state,
                             ceres::Problem* problem,
                             HardConstraint* constraint,
                             SolverSummary* summary);

}  // namespace musclewarp
