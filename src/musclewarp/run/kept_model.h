// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The OpenSim model of a run is kept in its folder, so that the run can be
// exported wherever it is taken. Its meshes are not needed for that.

// Where it is kept, from the folder of the run on.
inline constexpr char kKeptModel[] = "rest/model.osim";

// Copies the model of a scene, if it has one, to the folder of a run, of which
// the rest folder is written. A file that is there no more, as that of a scene
// which was read from a temporary folder, is not kept. Throws InputError if
// copying fails.
void KeepModel(const Scene& scene, const std::string& dir);

// Returns true if the folder of a run has its model; false for an empty `dir`.
bool IsModelKept(const std::string& dir);

// Returns the path of the model of a run: the one that is kept or, of runs of
// earlier builds, which keep none, the one that was read. `motion`: that of
// report.json. Throws InputError if a field is missing.
std::string ModelOfRun(const std::string& dir, const JsonField& motion);

}  // namespace musclewarp
