// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/hard_constraint_solver.h"

#include <glog/logging.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace musclewarp {

HardConstraintOptions::HardConstraintOptions() {
  ceres.minimizer_type = ceres::TRUST_REGION;
  ceres.linear_solver_type = ceres::CGNR;
  ceres.preconditioner_type = ceres::IDENTITY;
  ceres.initial_trust_region_radius = 1e8;
  ceres.max_num_iterations = 50;
  // Rounding of the cost ends a round by failed steps if these are tighter.
  ceres.function_tolerance = 1e-12;
  ceres.gradient_tolerance = 1e-7;
  ceres.parameter_tolerance = 1e-10;
  // An exact linear solve costs little in whitened unknowns.
  ceres.eta = 1e-8;
  ceres.logging_type = ceres::SILENT;
  ceres.num_threads = 1;
}

bool HardConstraintOptions::IsValid(std::string* error) const {
  const auto fail = [error](const std::string& rule) {
    *error = "HardConstraintOptions: " + rule;
    return false;
  };
  if (!(0 < initial_penalty && initial_penalty <= max_penalty)) {
    return fail("allowed: 0 < initial_penalty <= max_penalty");
  }
  if (!(penalty_factor > 1)) return fail("penalty_factor must be above 1");
  if (!(violation_tolerance > 0 && step_tolerance > 0)) {
    return fail("tolerances must be above 0");
  }
  if (max_rounds < 1) return fail("max_rounds must be above 0");
  return ceres.IsValid(error);
}

void SolveWithHardConstraint(const HardConstraintOptions& options,
                             const std::function<double()>& violation,
                             double* parameters,
                             int size,
                             ceres::Problem* problem,
                             HardConstraint* constraint,
                             SolverSummary* summary) {
  *summary = SolverSummary();
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  summary->iterations = 0;
  constraint->penalty = options.initial_penalty;
  constraint->multiplier = 0;
  const Eigen::Map<const Eigen::VectorXd> x(parameters, size);
  double previous_violation = std::abs(violation());

  for (int round = 0; round < options.max_rounds; ++round) {
    const Eigen::VectorXd before = x;
    ceres::Solver::Summary ceres_summary;
    ceres::Solve(options.ceres, problem, &ceres_summary);
    summary->iterations +=
        std::max<int>(0, static_cast<int>(ceres_summary.iterations.size()) - 1);
    if (!ceres_summary.IsSolutionUsable()) {
      summary->stop_reason = StopReason::kFailed;
      summary->message = ceres_summary.message;
      return;
    }
    const double c = violation();
    summary->max_step = (x - before).lpNorm<Eigen::Infinity>();
    summary->history.push_back({summary->max_step, c, 1, true});
    if (std::abs(c) <= options.violation_tolerance &&
        summary->max_step <= options.step_tolerance) {
      summary->stop_reason = StopReason::kConverged;
      summary->message = "";
      return;
    }
    constraint->multiplier += constraint->penalty * c;
    if (std::abs(c) > 0.25 * previous_violation) {
      constraint->penalty = std::min(
          options.max_penalty, constraint->penalty * options.penalty_factor);
    }
    previous_violation = std::abs(c);
  }
  summary->stop_reason = StopReason::kIterationLimit;
  summary->message = "max_rounds reached";
}

}  // namespace musclewarp
