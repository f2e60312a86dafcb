// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/group_progress.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "musclewarp/base/invalid_option.h"
#include "musclewarp/solver/volume_constraint.h"

namespace musclewarp {

bool GroupIterationOptions::IsValid(std::string* error) const {
  if (!step_length.IsValid(error)) return false;
  const auto fail = [error](
                        const std::string& field, auto value, auto allowed) {
    return InvalidOption(
        "GroupIterationOptions::" + field, value, allowed, error);
  };
  if (!(0 <= min_volume_fraction && min_volume_fraction <= 1)) {
    return fail("min_volume_fraction", min_volume_fraction, "0 to 1");
  }
  if (window < 1) return fail("window", window, "above 0");
  if (!(drift_threshold > 0)) {
    return fail("drift_threshold", drift_threshold, "above 0");
  }
  if (!(volume_tolerance > 0)) {
    return fail("volume_tolerance", volume_tolerance, "above 0");
  }
  if (max_iterations < 1) {
    return fail("max_iterations", max_iterations, "above 0");
  }
  return true;
}

GroupProgress::GroupProgress(const std::vector<const MuscleModel*>& models,
                             const std::vector<MuscleTarget>& targets,
                             const std::vector<MuscleState>& start,
                             const GroupIterationOptions& options,
                             const GroupContact& contact,
                             std::vector<SolverSummary>* summaries)
    : models_(models),
      targets_(targets),
      options_(options),
      summaries_(summaries),
      alpha_(options.step_length.initial_alpha),
      is_fine_volume_(contact.moves_fine_vertices()) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK(!models.empty());
  CHECK_EQ(models.size(), targets.size());
  CHECK_EQ(models.size(), start.size());
  summaries->assign(models.size(), SolverSummary());
  for (size_t i = 0; i < models.size(); ++i) {
    (*summaries)[i].iterations = 0;
    (*summaries)[i].initial_energy =
        LinearEnergy(*models[i], targets[i], start[i].coarse);
  }
}

void GroupProgress::Record(const GroupContact& contact,
                           const std::vector<double>& volume_errors) {
  bool is_volume_kept = is_fine_volume_;
  for (size_t i = 0; i < models_.size(); ++i) {
    SolverSummary& summary = (*summaries_)[i];
    summary.max_step = contact.max_move(static_cast<int>(i));
    summary.history.push_back(
        {summary.max_step, volume_errors[i], alpha_, is_fine_volume_});
    ++summary.iterations;
    is_volume_kept = is_volume_kept &&
                     std::abs(volume_errors[i]) < options_.volume_tolerance;
  }
  alpha_ = options_.step_length.Next(alpha_);
  const bool is_at_rest = Drift(contact) < options_.drift_threshold;
  if (is_over_) return;
  if (is_at_rest && is_volume_kept) {
    End(StopReason::kConverged, "");
  } else if (iterations() >= options_.max_iterations) {
    End(StopReason::kIterationLimit, "max_iterations reached");
  }
  is_fine_volume_ = is_fine_volume_ || is_at_rest;
}

double GroupProgress::volume_alpha() const {
  return alpha_ / std::max(alpha_, options_.min_volume_fraction);
}

void GroupProgress::Fail(int muscle, const std::string& message) {
  End(StopReason::kFailed, models_[muscle]->name + ": " + message);
}

void GroupProgress::Finish(const std::vector<MuscleState>& states) {
  for (size_t i = 0; i < models_.size(); ++i) {
    SolverSummary& summary = (*summaries_)[i];
    SummarizeSolution(*models_[i], targets_[i], states[i], &summary);
    summary.wall_ms = stopwatch_.Milliseconds();
  }
}

double GroupProgress::Drift(const GroupContact& contact) {
  const bool is_first = iterations() % options_.window == 1 % options_.window;
  if (is_first) {
    previous_sums_ = std::move(window_sums_);
    window_sums_.assign(models_.size(), Points());
  }
  for (size_t i = 0; i < models_.size(); ++i) {
    const Points& points = contact.points(static_cast<int>(i));
    if (is_first) {
      window_sums_[i] = points;
    } else {
      window_sums_[i] += points;
    }
  }
  if (iterations() % options_.window != 0 || previous_sums_.empty()) {
    return INFINITY;
  }
  double drift = 0;
  for (size_t i = 0; i < models_.size(); ++i) {
    const Points sum = window_sums_[i] - previous_sums_[i];
    drift =
        std::max(drift, sum.squaredNorm() / static_cast<double>(sum.rows()));
  }
  return std::sqrt(drift) / options_.window;
}

void GroupProgress::End(StopReason reason, const std::string& message) {
  is_over_ = true;
  for (SolverSummary& summary : *summaries_) {
    summary.stop_reason = reason;
    summary.message = message;
  }
}

}  // namespace musclewarp
