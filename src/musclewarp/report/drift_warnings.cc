// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/drift_warnings.h"

#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

namespace musclewarp {
namespace {

constexpr double kLargestDrift = 2;  // mm

struct WorstDrift {
  const FrameRecord* frame = nullptr;
  const MuscleRecord* muscle = nullptr;
  const AttachmentDrift* drift = nullptr;
};

std::string WarningOf(const WorstDrift& worst) {
  const AttachmentDrift& drift = *worst.drift;
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << worst.muscle->name << " leaves "
       << drift.body << ", to which it is attached, by up to " << drift.max
       << " mm (" << drift.mean << " on average) in " << worst.frame->name
       << " at (" << drift.place.x() << ", " << drift.place.y() << ", "
       << drift.place.z() << ")";
  return text.str();
}

}  // namespace

std::vector<std::string> DriftWarnings(const std::vector<FrameRecord>& frames) {
  std::map<std::pair<size_t, size_t>, WorstDrift> worst_of;
  for (const FrameRecord& frame : frames) {
    for (size_t m = 0; m < frame.muscles.size(); ++m) {
      const MuscleRecord& muscle = frame.muscles[m];
      for (size_t a = 0; a < muscle.attachments.size(); ++a) {
        const AttachmentDrift& drift = muscle.attachments[a];
        if (drift.max <= kLargestDrift) continue;
        WorstDrift& worst = worst_of[{m, a}];
        if (worst.drift && worst.drift->max >= drift.max) continue;
        worst = {&frame, &muscle, &drift};
      }
    }
  }
  std::vector<std::string> warnings;
  for (const auto& [area, worst] : worst_of) {
    warnings.push_back(WarningOf(worst));
  }
  return warnings;
}

}  // namespace musclewarp
