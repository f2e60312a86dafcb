// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/frame.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace musclewarp {

int Frame::iterations() const {
  int sum = 0;
  for (const MuscleFrame& muscle : muscles) sum += muscle.solver.iterations;
  return sum;
}

std::string Frame::stop_reason() const {
  for (const MuscleFrame& muscle : muscles) {
    if (muscle.solver.stop_reason == StopReason::kConverged) continue;
    return ToString(muscle.solver.stop_reason) + " (" + muscle.name + ")";
  }
  return ToString(StopReason::kConverged);
}

bool Frame::IsUsable() const {
  if (!shortcomings.empty()) return false;
  for (const MuscleFrame& muscle : muscles) {
    if (!muscle.solver.IsSolutionUsable()) return false;
  }
  return true;
}

double Frame::WorstVolumeError() const {
  double worst = 0;
  for (const MuscleFrame& muscle : muscles) {
    worst = std::max(worst, std::abs(muscle.volume_error));
  }
  return worst;
}

std::string Frame::BriefReport() const {
  std::ostringstream text;
  text << (name.empty() ? "frame" : name) << ": "
       << (IsUsable() ? "usable" : "NOT usable") << ", " << stop_reason()
       << ", " << intersections.triangle_pairs << " crossing triangle pairs, "
       << intersections.vertices_inside << " vertices inside, volume error "
       << std::scientific << std::setprecision(1) << WorstVolumeError() << ", "
       << std::fixed << std::setprecision(0) << wall_ms + certify_ms << " ms";
  return text.str();
}

std::string Frame::FullReport() const {
  std::ostringstream text;
  text << BriefReport() << "\n";
  for (const MuscleFrame& muscle : muscles) {
    text << "  " << muscle.name << ": " << muscle.solver.BriefReport()
         << "; moved by " << std::fixed << std::setprecision(1)
         << muscle.max_displacement << " mm, " << muscle.folded_triangles
         << " folded triangles, " << muscle.self_pairs
         << " self-intersecting pairs\n";
  }
  for (const std::string& shortcoming : shortcomings) {
    text << "  not usable: " << shortcoming << "\n";
  }
  return text.str();
}

}  // namespace musclewarp
