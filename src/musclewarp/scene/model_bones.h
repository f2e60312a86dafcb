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
// attachments, so that its bodies are unknown.
void CheckMusclesTellBodies(const JsonField& field, const Scene& scene);

// Adds a bone without a mesh for each of `bodies`, the bodies of the muscles'
// lines and attachments, to which the model attaches meshes. Throws InputError
// at `field` ("bones") if there is none.
void AddBonesOfMuscles(const ModelPoses& poses,
                       const std::vector<std::string>& bodies,
                       const JsonField& field,
                       Scene* scene);

// Replaces every bone without a mesh by the meshes that the model attaches to
// its body: one bone for each mesh, named <bone>_<file> if there are several.
// `folders` are searched as in FindGeometry. Throws InputError, beginning with
// `where`, if the body has no mesh or a file does not exist.
void AddMeshesOfModel(const ModelPoses& poses,
                      const std::vector<std::string>& folders,
                      const std::string& where,
                      Scene* scene);

}  // namespace musclewarp
