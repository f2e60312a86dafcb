// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "musclewarp/run/report_json.h"

namespace musclewarp {

// Prints what was prepared, for people: the scene, how long that took, and a
// line for each muscle and bone.
void PrintPreparation(const PreparedScene& scene,
                      const ContactReport& contact,
                      std::ostream& out);

// Prints a table of the frames, what those that are not usable lack, and the
// totals of the run: "usable" says there what it was tested for.
void PrintFrames(const RunRecord& run, std::ostream& out);

// Returns ", cavities of 2.1 cm3 filled", or nothing if none were.
std::string FilledCavities(const RepairReport& repairs);

// Says which bones cross each other as they were delivered, a line for each
// two.
void PrintBoneCrossings(const PreparedScene& scene, std::ostream& out);

}  // namespace musclewarp
