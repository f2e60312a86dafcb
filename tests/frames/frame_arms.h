// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// The moment arms of all lines of a muscle, then of all its fibres, muscle by
// muscle.
inline std::vector<double> Arms(const PreparedScene& scene,
                                const Frame& frame,
                                const std::string& coordinate) {
  std::vector<double> all;
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    const MuscleFigures& muscle = frame.muscles[i];
    for (const ActionLine& line : scene.muscles[i].model.lines) {
      all.push_back(muscle.line_moment_arms.at(line.name).at(coordinate));
    }
    const auto of_fibres = muscle.fibre_moment_arms.find(coordinate);
    if (of_fibres == muscle.fibre_moment_arms.end()) {
      all.resize(all.size() + scene.muscles[i].fibres.num_lines(), 0);
    } else {
      for (const double arm : of_fibres->second) all.push_back(arm);
    }
  }
  return all;
}

}  // namespace musclewarp
