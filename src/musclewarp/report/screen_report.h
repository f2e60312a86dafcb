// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "musclewarp/report/report_json.h"

namespace musclewarp {

// The same run for people: a line per muscle, a table of the frames, totals.
void PrintPreparation(const PreparedScene& scene, std::ostream& out);
void PrintFrames(const RunRecord& run, std::ostream& out);

}  // namespace musclewarp
