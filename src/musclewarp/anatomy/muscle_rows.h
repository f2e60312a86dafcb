// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace musclewarp {

// A muscle as the tables have it. The ends are names of landmarks with blanks
// between them, the main one first, the aliases names with commas between them.
// `pulleys` are landmarks, too: see MuscleFacts.
struct MuscleRow {
  const char* name;
  const char* fma_id;
  const char* source;
  const char* origins;
  const char* insertions;
  const char* aliases;
  const char* pulleys = "";
};

// The tables, by regions of the body.
std::vector<MuscleRow> MuscleRowsOfThigh();     // and hip
std::vector<MuscleRow> MuscleRowsOfLeg();       // and foot
std::vector<MuscleRow> MuscleRowsOfShoulder();  // and upper arm
std::vector<MuscleRow> MuscleRowsOfForearm();   // and hand

}  // namespace musclewarp
