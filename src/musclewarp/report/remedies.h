// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/run/report_json.h"

namespace musclewarp {

// Returns what users can do about a run that is not usable, a line each, with
// settings in braces: which frames before the first bad one are usable and the
// flag that computes them alone, and for each kind of shortcoming the setting
// of its limit and what usually helps. Empty if the run is usable.
// Precondition: the frames of the run are in their order.
std::vector<std::string> RemediesFor(const RunRecord& run);

// Returns the line on a shortcoming of a frame, a sentence that
// certificate/shortcomings.h or a frame solver makes; empty for one that says
// itself what to do.
std::string RemedyFor(const std::string& shortcoming);

}  // namespace musclewarp
