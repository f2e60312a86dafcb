// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/gauss_newton.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/base/stopwatch.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/solver/volume_constraint.h"

namespace musclewarp {
namespace {

// The linearised volume constraint J_g (alpha h) = -dV.
struct VolumeRow {
  double error = 0;  // dV, mm^3
  Points gradient;   // J_g^T, N x 3
};

double MaxRowNorm(const Points& rows) {
  return rows.rowwise().norm().maxCoeff();
}

class GaussNewton {
 public:
  GaussNewton(const MuscleModel& model,
              const MuscleTarget& target,
              const GaussNewtonOptions& options,
              Points* coarse,
              SolverSummary* summary)
      : model_(model),
        options_(options),
        minimizer_(UnconstrainedMinimizer(model, target)),
        coarse_rest_volume_(
            SignedVolume(model.coarse_rest, model.coarse_triangles)),
        coarse_(*coarse),
        summary_(*summary) {}

  // The iterations of the paper; with polishing, as far as full steps take
  // over.
  void Iterate() {
    const bool polishes = options_.polish_threshold > 0;
    const double step_threshold =
        polishes ? options_.polish_start : options_.step_threshold;
    double alpha = options_.initial_alpha;
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
      alpha = std::max(options_.final_alpha, alpha * options_.alpha_decay);
    }
    Finish(StopReason::kIterationLimit, "max_iterations reached");
  }

 private:
  VolumeRow CoarseRow() const {
    const double error =
        SignedVolume(coarse_, model_.coarse_triangles) - coarse_rest_volume_;
    return {error * model_.rest_volume / coarse_rest_volume_,
            VolumeGradient(coarse_, model_.coarse_triangles)};
  }

  VolumeRow FineRow() const {
    FineVolume volume = EvaluateFineVolume(model_, coarse_);
    return {volume.error, std::move(volume.gradient)};
  }

  // X <- X + alpha h. False if the step cannot be computed.
  bool Step(double alpha, bool is_fine) {
    const VolumeRow row = is_fine ? FineRow() : CoarseRow();
    // -A^-1 J_f^T f = X* - X, because f is linear.
    const Points to_minimizer = minimizer_ - coarse_;
    const Points inverse_gradient = model_.normal_matrix.solve(row.gradient);
    const double denominator =
        row.gradient.cwiseProduct(inverse_gradient).sum();
    const double lambda =
        (row.error / alpha + row.gradient.cwiseProduct(to_minimizer).sum()) /
        denominator;
    const Points h = to_minimizer - lambda * inverse_gradient;
    if (!(denominator > 0) || !h.allFinite()) {
      Finish(StopReason::kFailed,
             "the volume gradient vanished or a step is not finite");
      return false;
    }
    coarse_ += alpha * h;
    summary_.max_step = alpha * MaxRowNorm(h);
    summary_.history.push_back(
        {summary_.max_step, row.error / model_.rest_volume, alpha, is_fine});
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

  // The error is that of the state the last step started from; a step corrects
  // it to first order, so what is left is smaller.
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
  const double coarse_rest_volume_;
  Points& coarse_;
  SolverSummary& summary_;
};

}  // namespace

bool GaussNewtonOptions::IsValid(std::string* error) const {
  const auto fail = [error](const std::string& rule) {
    *error = "GaussNewtonOptions: " + rule;
    return false;
  };
  if (!(0 < final_alpha && final_alpha <= initial_alpha &&
        initial_alpha <= 1)) {
    return fail("allowed: 0 < final_alpha <= initial_alpha <= 1");
  }
  if (!(0 < alpha_decay && alpha_decay <= 1)) {
    return fail("allowed: 0 < alpha_decay <= 1");
  }
  if (!(step_threshold > 0)) return fail("step_threshold must be above 0");
  if (!(volume_tolerance > 0)) return fail("volume_tolerance must be above 0");
  if (!(fine_volume_threshold >= 0)) {
    return fail("fine_volume_threshold must not be negative");
  }
  if (max_iterations < 1) return fail("max_iterations must be above 0");
  if (max_coarse_iterations < 0) {
    return fail("max_coarse_iterations must not be negative");
  }
  if (!(0 <= polish_threshold && polish_threshold <= polish_start)) {
    return fail("allowed: 0 <= polish_threshold <= polish_start");
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

  GaussNewton(model, target, options, coarse, summary).Iterate();
  SummarizeSolution(model, target, *coarse, summary);
  summary->wall_ms = stopwatch.Milliseconds();
}

}  // namespace musclewarp
