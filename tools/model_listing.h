// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/scene/model_sources.h"

namespace musclewarp {

// Prints the parts of an OpenSim model that a scene can name: its bodies with
// their meshes and the places of these files, its muscles with the bodies on
// which they lie, its coordinates and, if `sources` names a motion, the range
// of each in it. Parts that a scene could not use are marked with the reason.
// Throws InputError if the model or the motion cannot be read.
void PrintModel(const std::string& path,
                const ModelSources& sources,
                std::ostream& screen);

}  // namespace musclewarp
