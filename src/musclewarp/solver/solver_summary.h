// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// Why a solver stopped.
enum class StopReason {
  kNotRun,          // the solver was not called
  kConverged,       // step and volume error are below their thresholds
  kIterationLimit,  // the limit of iterations came before that
  kFailed,          // a step could not be computed
};

// Returns the text of the reports: "not_run", "converged", "iteration_limit" or
// "failed".
std::string ToString(StopReason reason);

// One iteration in the history of a solve.
struct SolverIteration {
  double max_step = 0;          // largest move of a coarse vertex, mm
  double volume_error = 0;      // relative, where the step started
  double alpha = 0;             // step length; 1 for Ceres
  bool is_fine_volume = false;  // whether the error is that of the fine mesh
};

// The outcome of a solve, of any of the solvers. Solvers report failure here
// and do not throw. A summary starts out as not run, with values that are
// impossible, so that a solve that was forgotten is noticed.
struct SolverSummary {
  StopReason stop_reason = StopReason::kNotRun;

  // Why the solver stopped, in words; empty if it converged.
  std::string message = "the solver was not called";

  int iterations = -1;
  double initial_energy = -1;  // 1/2 |f|^2 at the start, mm^2
  double final_energy = -1;    // the same at the end
  double volume_ratio = -1;    // V(W X) / V_hat, of the fine mesh
  double max_step = -1;        // of the last iteration, mm
  double wall_ms = -1;         // wall time, ms
  std::vector<SolverIteration> history;

  // Whether the solver converged. A state that is merely close is not usable,
  // because its volume may be wrong.
  bool IsSolutionUsable() const;

  // One line: stop reason, iterations, time, energies, volume ratio.
  std::string BriefReport() const;

  // The brief report followed by a table with one row per iteration.
  std::string FullReport() const;
};

// Returns the summary of a muscle that is at its target without a solve.
SolverSummary NothingToSolve();

// Merges the summaries of two solves of which `second` started where `first`
// ended. Iterations and times are added and the histories joined; the initial
// energy is that of the first, everything else that of the second.
SolverSummary MergedSummary(const SolverSummary& first, SolverSummary second);

}  // namespace musclewarp
