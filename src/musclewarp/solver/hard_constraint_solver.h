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

// An equality constraint c(x) = target in a Ceres problem, which knows no
// equality constraints of its own. The constraint is carried by one residual,
//
//   r = sqrt(penalty) (c(x) - target + multiplier / penalty),
//
// so that 1/2 r^2 is the term of the augmented Lagrangian up to a constant
// (Nocedal and Wright, Numerical Optimization, 2nd edition, section 17.3). The
// residual block keeps a pointer to this struct and reads it at every
// evaluation; SolveWithHardConstraint changes it between solves.
//
// c is in the units of the residual; musclewarp uses mm.
struct HardConstraint {
  double penalty = 1;
  double multiplier = 0;
  double target = 0;

  // Returns r for a value of c(x).
  double Residual(double c) const;

  // Adapts the multiplier and the penalty after a round that ended at
  // `violation` = c - target. The violation counts as fallen if it is at most a
  // quarter of `previous_violation`, that of the round before.
  //
  // - If it has fallen, or if the round reached the minimum of its problem
  //   (`is_minimum`), the multiplier grows by penalty * violation.
  // - If it has not fallen, the penalty is multiplied by penalty_factor, up to
  //   max_penalty.
  //
  // Returns true if the violation has fallen.
  bool Update(const HardConstraintOptions& options,
              double violation,
              double previous_violation,
              bool is_minimum);
};

struct HardConstraintOptions {
  // The penalty starts soft. After every round that did not reduce the
  // violation to a quarter it is multiplied by penalty_factor, up to
  // max_penalty. A penalty that is hard from the start stalls: each step would
  // then have to follow the curved surface c = target.
  double initial_penalty = 1e3;
  double penalty_factor = 10;
  double max_penalty = 1e6;

  // The solver has converged when |c - target| and the change of the state in
  // a round (max norm) are at most these; mm in musclewarp.
  double violation_tolerance = 1e-8;
  double step_tolerance = 1e-5;

  // The solver gives up after this many rounds.
  int max_rounds = 100;

  // How Ceres solves a round. The constructor chooses values that suit whitened
  // unknowns: conjugate gradients without a preconditioner.
  ceres::Solver::Options ceres;

  HardConstraintOptions();

  // Returns false and names the field, its value and the rule if a field, one
  // of `ceres` included, is out of range.
  bool IsValid(std::string* error) const;
};

// Minimises `problem` subject to a constraint by the method of multipliers:
// each round lets Ceres take a step, then updates the multiplier and the
// penalty (HardConstraint::Update). A round is one step as long as the
// violation falls, and becomes longer when it does not: a precise minimum for a
// wrong multiplier is not worth its price.
//
// - `problem` has the residual of `constraint` among its residuals.
// - `violation` returns c - target at the current parameters.
// - `state` returns the vector in which the length of steps is measured.
// - `constraint` provides the first penalty and multiplier, and has the last
//   ones on return, so that a later solve can go on from there.
// - `summary` is filled except for the energies and the volume ratio, which
//   this function does not know; its history has violations as volume errors.
//
// Precondition (CHECKed): the options are valid.
void SolveWithHardConstraint(const HardConstraintOptions& options,
                             const std::function<double()>& violation,
                             const std::function<Eigen::VectorXd()>& state,
                             ceres::Problem* problem,
                             HardConstraint* constraint,
                             SolverSummary* summary);

}  // namespace musclewarp
