// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "musclewarp/figures/frame_figures.h"

namespace musclewarp {

// Returns frames as report.json has them, without what the page does not show:
// places, fibres and gaps between pairs of meshes, which are most of the
// figures of many muscles.
nlohmann::ordered_json ShownFrames(const std::vector<FrameFigures>& figures);

}  // namespace musclewarp
