// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

enum class StopReason {
  kNotRun,          // the solver was not called
  kConverged,       // step and volume error below their thresholds
  kIterationLimit,  // stopped before that
  kFailed,          // a step could not be computed
};

// "converged", ...: the text of the reports.
std::string ToString(StopReason reason);

struct SolverIteration {
  double max_step = 0;      // largest move of a coarse vertex, mm
  double volume_error = 0;  // relative, of the mesh the step was based on
  double alpha = 0;         // step length; 1 for Ceres
  bool is_fine_volume = false;
};

// What a solve did. Starts in the failed state, so that a forgotten solve
// shows.
struct SolverSummary {
  StopReason stop_reason = StopReason::kNotRun;
  std::string message = "the solver was not called";
  int iterations = -1;
  double initial_energy = -1;  // 1/2 |f|^2, mm^2
  double final_energy = -1;
  double volume_ratio = -1;  // V(W X) / V_hat
  double max_step = -1;      // of the last iteration, mm
  double wall_ms = -1;
  std::vector<SolverIteration> history;

  bool IsSolutionUsable() const;
  std::string BriefReport() const;
  // The brief report and a row per iteration.
  std::string FullReport() const;
};

// Of a solve that goes on from where the first one came: iterations and times
// added up.
SolverSummary Following(const SolverSummary& first, SolverSummary second);

}  // namespace musclewarp
