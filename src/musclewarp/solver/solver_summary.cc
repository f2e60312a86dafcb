// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/solver_summary.h"

#include <iomanip>
#include <sstream>

namespace musclewarp {

std::string ToString(StopReason reason) {
  switch (reason) {
    case StopReason::kNotRun:
      return "not_run";
    case StopReason::kConverged:
      return "converged";
    case StopReason::kIterationLimit:
      return "iteration_limit";
    case StopReason::kFailed:
      return "failed";
  }
  return "unknown";
}

bool SolverSummary::IsSolutionUsable() const {
  return stop_reason == StopReason::kConverged;
}

std::string SolverSummary::BriefReport() const {
  std::ostringstream report;
  report << ToString(stop_reason) << " after " << iterations << " iterations, "
         << std::fixed << std::setprecision(1) << wall_ms << " ms, energy "
         << std::setprecision(4) << initial_energy << " -> " << final_energy
         << " mm^2, volume ratio " << std::setprecision(8) << volume_ratio;
  if (!message.empty()) report << " (" << message << ")";
  return report.str();
}

std::string SolverSummary::FullReport() const {
  std::ostringstream report;
  report << BriefReport() << "\n  iteration   alpha     max step mm"
         << "    volume error  volume of\n";
  for (size_t k = 0; k < history.size(); ++k) {
    const SolverIteration& row = history[k];
    report << std::setw(11) << k + 1 << std::setw(8) << std::setprecision(3)
           << row.alpha << std::scientific << std::setw(16) << row.max_step
           << std::setw(16) << row.volume_error << std::defaultfloat
           << (row.is_fine_volume ? "  fine mesh\n" : "  coarse mesh\n");
  }
  return report.str();
}

SolverSummary NothingToSolve() {
  SolverSummary summary;
  summary.stop_reason = StopReason::kConverged;
  summary.message.clear();
  summary.iterations = 0;
  summary.initial_energy = summary.final_energy = 0;
  summary.volume_ratio = 1;
  summary.max_step = 0;
  summary.wall_ms = 0;
  return summary;
}

SolverSummary MergedSummary(const SolverSummary& first, SolverSummary second) {
  second.iterations += first.iterations;
  second.wall_ms += first.wall_ms;
  second.initial_energy = first.initial_energy;
  second.history.insert(
      second.history.begin(), first.history.begin(), first.history.end());
  return second;
}

}  // namespace musclewarp
