// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/report/frame_record.h"

namespace musclewarp {

// Returns a sentence for every attachment area that leaves its body by more
// than 2 mm in some frame, which is beyond anatomy: by how much at most, in
// which frame and where. Frames may be usable nevertheless.
std::vector<std::string> DriftWarnings(const std::vector<FrameRecord>& frames);

}  // namespace musclewarp
