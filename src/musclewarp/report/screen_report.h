// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "musclewarp/run/report_json.h"

namespace musclewarp {

// Prints a summary of the preparation: the scene, the time that it took, and a
// line for each muscle and bone.
void PrintPreparation(const PreparedScene& scene,
                      const ContactReport& contact,
                      std::ostream& out);

// Prints a table of the frames, the shortcomings of unusable frames, the totals
// of the run, and what helps if it is not usable (report/remedies.h). Its
// verdict names the tests that it includes. Frames are called as in
// run/pose_name.h.
void PrintFrames(const RunRecord& run, std::ostream& out);

// Returns ", cavities of 2.1 cm3 filled", or an empty text if none were.
std::string FilledCavities(const RepairReport& repairs);

// Prints a line for each pair of bones that cross each other as delivered.
void PrintBoneCrossings(const PreparedScene& scene, std::ostream& out);

}  // namespace musclewarp
