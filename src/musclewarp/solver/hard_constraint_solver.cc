// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/hard_constraint_solver.h"

#include <ceres/iteration_callback.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/base/invalid_option.h"

namespace musclewarp {
namespace {

// Ends a solve after a number of successful steps. The limit of iterations that
// Ceres has would count rejected steps, too.
struct StopAfterSteps : public ceres::IterationCallback {
  ceres::CallbackReturnType operator()(
      const ceres::IterationSummary& iteration) override {
    if (iteration.iteration == 0) {
      steps = 0;
    } else if (iteration.step_is_successful) {
      ++steps;
    }
    return steps >= max_steps ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                              : ceres::SOLVER_CONTINUE;
  }

  int max_steps = 1;
  int steps = 0;
};

}  // namespace

HardConstraintOptions::HardConstraintOptions() {
  ceres.minimizer_type = ceres::TRUST_REGION;
  ceres.linear_solver_type = ceres::CGNR;
  ceres.preconditioner_type = ceres::IDENTITY;
  ceres.initial_trust_region_radius = 1e8;
  ceres.max_num_iterations = 50;
  // Whitened unknowns are well scaled as they are. With columns scaled one by
  // one, conjugate gradients would need 20 steps instead of 3.
  ceres.jacobi_scaling = false;
  // With tighter tolerances, rounding of the cost would end rounds by failed
  // steps.
  ceres.function_tolerance = 1e-14;
  ceres.gradient_tolerance = 1e-7;
  ceres.parameter_tolerance = 1e-10;
  // An exact linear solve costs little in whitened unknowns.
  ceres.eta = 1e-8;
  ceres.logging_type = ceres::SILENT;
  ceres.num_threads = 1;
}

bool HardConstraintOptions::IsValid(std::string* error) const {
  const auto fail = [error](
                        const std::string& field, auto value, auto allowed) {
    return InvalidOption(
        "HardConstraintOptions::" + field, value, allowed, error);
  };
  if (!(0 < initial_penalty && initial_penalty <= max_penalty)) {
    return fail(
        "initial_penalty", initial_penalty, "above 0 and at most max_penalty");
  }
  if (!(penalty_factor > 1)) {
    return fail("penalty_factor", penalty_factor, "above 1");
  }
  if (!(violation_tolerance > 0)) {
    return fail("violation_tolerance", violation_tolerance, "above 0");
  }
  if (!(step_tolerance > 0)) {
    return fail("step_tolerance", step_tolerance, "above 0");
  }
  if (max_rounds < 1) return fail("max_rounds", max_rounds, "above 0");
  return ceres.IsValid(error);
}

double HardConstraint::Residual(double c) const {
  return std::sqrt(penalty) * (c - target + multiplier / penalty);
}

bool HardConstraint::Update(const HardConstraintOptions& options,
                            double violation,
                            double previous_violation,
                            bool is_minimum) {
  const bool has_fallen =
      std::abs(violation) <= 0.25 * std::abs(previous_violation);
  if (has_fallen || is_minimum) multiplier += penalty * violation;
  if (!has_fallen) {
    penalty = std::min(options.max_penalty, penalty * options.penalty_factor);
  }
  return has_fallen;
}

void SolveWithHardConstraint(const HardConstraintOptions& options,
                             const std::function<double()>& violation,
                             const std::function<Eigen::VectorXd()>& state,
                             ceres::Problem* problem,
                             HardConstraint* constraint,
                             SolverSummary* summary) {
  *summary = SolverSummary();
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  summary->iterations = 0;
  double previous_violation = violation();
  Eigen::VectorXd before = state();
  // While the multiplier is wrong, the exact minimum is worth no more than a
  // step towards it. So a round is one step, unless the violation stops
  // falling.
  StopAfterSteps short_round;
  ceres::Solver::Options ceres_options = options.ceres;
  ceres_options.callbacks.push_back(&short_round);

  for (int round = 0; round < options.max_rounds; ++round) {
    ceres::Solver::Summary ceres_summary;
    ceres::Solve(ceres_options, problem, &ceres_summary);
    summary->iterations +=
        std::max<int>(0, static_cast<int>(ceres_summary.iterations.size()) - 1);
    if (!ceres_summary.IsSolutionUsable()) {
      summary->stop_reason = StopReason::kFailed;
      summary->message = ceres_summary.message;
      return;
    }
    const double c = violation();
    const Eigen::VectorXd after = state();
    summary->max_step = (after - before).lpNorm<Eigen::Infinity>();
    before = after;
    summary->history.push_back({summary->max_step, c, 1, true});
    if (std::abs(c) <= options.violation_tolerance &&
        summary->max_step <= options.step_tolerance) {
      summary->stop_reason = StopReason::kConverged;
      summary->message = "";
      return;
    }
    if (!constraint->Update(
            options,
            c,
            previous_violation,
            ceres_summary.termination_type == ceres::CONVERGENCE)) {
      short_round.max_steps =
          std::min(2 * short_round.max_steps, ceres_options.max_num_iterations);
    }
    previous_violation = c;
  }
  summary->stop_reason = StopReason::kIterationLimit;
  summary->message = "max_rounds reached";
}

}  // namespace musclewarp
