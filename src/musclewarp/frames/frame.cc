// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/frame.h"

#include <iomanip>
#include <sstream>

namespace musclewarp {

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
