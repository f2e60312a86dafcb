// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Figures as JSON, compiled once for all that write or read them.

#include <vector>

#include "musclewarp/base/described_json.h"
#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/figures/run_figures.h"

namespace musclewarp {

extern template nlohmann::ordered_json JsonOf(const FrameFigures&);
extern template nlohmann::ordered_json JsonOf(const std::vector<FrameFigures>&);
extern template nlohmann::ordered_json JsonOf(const RunFigures&);
extern template nlohmann::ordered_json JsonOf(const SceneIntersections&);

extern template void ReadJson(const nlohmann::json&,
                              const FieldPath&,
                              FrameFigures*);
extern template void ReadJson(const nlohmann::json&,
                              const FieldPath&,
                              std::vector<FrameFigures>*);

extern template bool IsValid(const std::vector<FrameFigures>&,
                             std::string*,
                             const FieldPath&);

}  // namespace musclewarp
