// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns true if a scene file asks for the bones of its model:
// "bones": "model".
bool AreBonesOfModel(const JsonField& scene);

// Throws InputError at `field` ("bones") if a muscle has neither lines nor
// attachments, so that it does not tell on which bodies it is.
void CheckMusclesTellBodies(const JsonField& field, const Scene& scene);

// Adds a bone without mesh for each body to which the model attaches meshes,
// out of `bodies`, on which the lines and attachments of the muscles are.
// Throws InputError at `field` ("bones") if there is none.
void AddBonesOfMuscles(const ModelPoses& poses,
                       const std::vector<std::string>& bodies,
                       const JsonField& field,
                       Scene* scene);

// Replaces every bone without mesh by the meshes that the model attaches to its
// body, one bone each, named <bone>_<file> if there are several. `folders` are
// searched as in FindGeometry. Throws InputError that begins with `where` if
// there is no mesh, or if a file is not there.
void AddMeshesOfModel(const ModelPoses& poses,
                      const std::vector<std::string>& folders,
                      const std::string& where,
                      Scene* scene);

}  // namespace musclewarp
