// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/figures/figures_json.h"

namespace musclewarp {

template nlohmann::ordered_json JsonOf(const FrameFigures&);
template nlohmann::ordered_json JsonOf(const std::vector<FrameFigures>&);
template nlohmann::ordered_json JsonOf(const RunFigures&);
template nlohmann::ordered_json JsonOf(const SceneIntersections&);

template void ReadJson(const nlohmann::json&, const FieldPath&, FrameFigures*);
template void ReadJson(const nlohmann::json&,
                       const FieldPath&,
                       std::vector<FrameFigures>*);

template bool IsValid(const std::vector<FrameFigures>&,
                      std::string*,
                      const FieldPath&);

}  // namespace musclewarp
