// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/scene/model_sources.h"

namespace musclewarp {

// Prints what a scene can name of an OpenSim model: its bodies with their
// meshes and where these are, its muscles with the bodies on which they are,
// its coordinates, and the range of each in a motion if `sources` names one.
// What a scene could not use is marked with the reason. Throws InputError if
// the model or the motion cannot be read.
void PrintModel(const std::string& path,
                const ModelSources& sources,
                std::ostream& screen);

}  // namespace musclewarp
