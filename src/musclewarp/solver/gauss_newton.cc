// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/gauss_newton.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "musclewarp/base/invalid_option.h"
#include "musclewarp/base/stopwatch.h"
#include "musclewarp/solver/gauss_newton_step.h"
#include "musclewarp/solver/volume_constraint.h"

namespace musclewarp {
namespace {

double MaxRowNorm(const Points& rows) {
  return rows.rowwise().norm().maxCoeff();
}

class GaussNewton {
 public:
  GaussNewton(const MuscleModel& model,
              const MuscleTarget& target,
              const GaussNewtonOptions& options,
              MuscleState* state,
              SolverSummary* summary)
      : model_(model),
        options_(options),
        minimizer_(UnconstrainedMinimizer(model, target)),
        one_sided_(model, target.one_sided),
        state_(*state),
        summary_(*summary) {}

  // Takes the damped steps of the paper, until they have converged or, with
  // polishing, until full steps take over.
  void Iterate() {
    const bool polishes = options_.polish_threshold > 0;
    const double step_threshold =
        polishes ? options_.polish_start : options_.step_threshold;
    double alpha = options_.step_length.initial_alpha;
    bool is_fine = options_.max_coarse_iterations == 0;
    while (summary_.iterations < options_.max_iterations) {
      if (!Step(alpha, is_fine)) return;
      if (is_fine && summary_.max_step < step_threshold &&
          (polishes || VolumeIsKept())) {
        if (polishes) return Polish();
        return Finish(StopReason::kConverged, "");
      }
      is_fine = is_fine ||
                summary_.max_step < alpha * options_.fine_volume_threshold ||
                summary_.iterations >= options_.max_coarse_iterations;
      alpha = options_.step_length.Next(alpha);
    }
    Finish(StopReason::kIterationLimit, "max_iterations reached");
  }

 private:
  // Takes the step X <- X + alpha h. Returns false if it cannot be computed.
  bool Step(double alpha, bool is_fine) {
    const GaussNewtonStep step = ComputeGaussNewtonStep(
        model_, minimizer_, state_, alpha, is_fine, &one_sided_);
    if (!step.is_finite) {
      Finish(StopReason::kFailed, "the volume gradient vanished");
      return false;
    }
    state_.coarse += alpha * step.h;
    summary_.max_step = alpha * MaxRowNorm(step.h);
    summary_.history.push_back({summary_.max_step,
                                step.volume_error / model_.rest_volume,
                                alpha,
                                is_fine});
    ++summary_.iterations;
    return true;
  }

  void Polish() {
    while (summary_.iterations < options_.max_iterations) {
      if (!Step(1, /*is_fine=*/true)) return;
      if (summary_.max_step < options_.polish_threshold && VolumeIsKept()) {
        return Finish(StopReason::kConverged, "");
      }
    }
    Finish(StopReason::kIterationLimit, "max_iterations reached");
  }

  // The error is that of the state from which the last step started. The step
  // has corrected it to first order, so that less is left.
  bool VolumeIsKept() const {
    return std::abs(summary_.history.back().volume_error) <
           options_.volume_tolerance;
  }

  void Finish(StopReason reason, const std::string& message) {
    summary_.stop_reason = reason;
    summary_.message = message;
  }

  const MuscleModel& model_;
  const GaussNewtonOptions& options_;
  const Points minimizer_;  // X*
  OneSidedSystem one_sided_;
  MuscleState& state_;
  SolverSummary& summary_;
};

}  // namespace

bool GaussNewtonOptions::IsValid(std::string* error) const {
  const auto fail = [error](
                        const std::string& field, auto value, auto allowed) {
    return InvalidOption("GaussNewtonOptions::" + field, value, allowed, error);
  };
  if (!step_length.IsValid(error)) return false;
  if (!(fine_volume_threshold >= 0)) {
    return fail("fine_volume_threshold", fine_volume_threshold, "0 or above");
  }
  if (max_coarse_iterations < 0) {
    return fail("max_coarse_iterations", max_coarse_iterations, "0 or above");
  }
  if (!(step_threshold > 0)) {
    return fail("step_threshold", step_threshold, "above 0");
  }
  if (!(volume_tolerance > 0)) {
    return fail("volume_tolerance", volume_tolerance, "above 0");
  }
  if (max_iterations < 1) {
    return fail("max_iterations", max_iterations, "above 0");
  }
  if (!(0 <= polish_threshold && polish_threshold <= polish_start)) {
    return fail("polish_threshold", polish_threshold, "0 to polish_start");
  }
  return true;
}

void SolveGaussNewton(const MuscleModel& model,
                      const MuscleTarget& target,
                      const GaussNewtonOptions& options,
                      Points* coarse,
                      SolverSummary* summary) {
  const Stopwatch stopwatch;
  *summary = SolverSummary();
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK_EQ(coarse->rows(), model.coarse_rest.rows());
  summary->iterations = 0;
  summary->initial_energy = LinearEnergy(model, target, *coarse);

  MuscleState state;
  state.coarse = *coarse;
  GaussNewton(model, target, options, &state, summary).Iterate();
  SummarizeSolution(model, target, state, summary);
  *coarse = std::move(state.coarse);
  summary->wall_ms = stopwatch.Milliseconds();
}

}  // namespace musclewarp
