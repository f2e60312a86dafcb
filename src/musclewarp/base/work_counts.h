// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace musclewarp {

// What the stages of a computation have much of. The time of a stage divided by
// such a count is what a faster algorithm has to beat.
enum class WorkUnit {
  kPairsVisited,   // pairs of triangles whose boxes overlap
  kPairsTested,    // pairs of triangles that are measured or separated
  kPlanes,         // separating planes that are found
  kHalfSpaces,     // of vertices
  kVertexSweeps,   // vertices that are relaxed, in all sweeps
  kMatrixEntries,  // of W, with each product
  kRows,           // one-sided rows of the coarse solve
};
constexpr int kNumWorkUnits = 7;
using WorkCounts = std::array<std::int64_t, kNumWorkUnits>;

// "pairs visited", ...
const char* ToString(WorkUnit unit);

// Adds to the work of the process. May be called by several threads at a time;
// it costs some nanoseconds, so that loops count once at their end.
void CountWork(WorkUnit unit, std::int64_t count);

// Returns the work since the process began.
WorkCounts WorkSoFar();

}  // namespace musclewarp
