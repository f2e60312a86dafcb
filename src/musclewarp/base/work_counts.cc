// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/work_counts.h"

#include <glog/logging.h>

#include <atomic>

namespace musclewarp {
namespace {

std::array<std::atomic<std::int64_t>, kNumWorkUnits> work_of_process = {};

}  // namespace

const char* ToString(WorkUnit unit) {
  switch (unit) {
    case WorkUnit::kPairsVisited:
      return "pairs visited";
    case WorkUnit::kPairsTested:
      return "pairs tested";
    case WorkUnit::kPlanes:
      return "planes";
    case WorkUnit::kHalfSpaces:
      return "half-spaces";
    case WorkUnit::kVertexSweeps:
      return "vertex sweeps";
    case WorkUnit::kMatrixEntries:
      return "entries of W";
    case WorkUnit::kRows:
      return "rows";
  }
  LOG(FATAL) << "no such unit of work";
}

void CountWork(WorkUnit unit, std::int64_t count) {
  work_of_process[static_cast<size_t>(unit)].fetch_add(
      count, std::memory_order_relaxed);
}

WorkCounts WorkSoFar() {
  WorkCounts counts;
  for (size_t i = 0; i < counts.size(); ++i) {
    counts[i] = work_of_process[i].load(std::memory_order_relaxed);
  }
  return counts;
}

}  // namespace musclewarp
