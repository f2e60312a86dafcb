// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "musclewarp/joints/line_muscle.h"

namespace musclewarp {

// Adds a <ForceSet> with a Millard2012EquilibriumMuscle for each of `muscles`
// to a <Model> in whose rest pose the frames of all bodies coincide with the
// ground. Each point of a line is a PathPoint of its body, in m; what else the
// muscle needs are estimates (EstimateMuscle), and comments say so.
// Precondition (CHECKed): every point of a line has a body, which is among
// `bodies`.
//
// Sources: the elements are those of opensim-core 4 (GeometryPath, PathPoint,
// Millard2012EquilibriumMuscle), as its own models have them.
void AddMuscles(const std::vector<std::string>& bodies,
                const std::vector<LineMuscle>& muscles,
                pugi::xml_node model);

}  // namespace musclewarp
