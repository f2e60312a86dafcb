// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/model_sources.h"

namespace musclewarp {

struct Scene;

// Puts a scene whose muscles and bones have been read on its model. It fills in
// what the scene takes from the model, that is the rest points of lines which
// are paths of muscles, and the meshes of bones which name none, and makes one
// pose of every row of the motion, which is a file or part of the scene file.
//
// `field` is the scene file, and paths in it are relative to `root`. Throws
// InputError if the motion cannot be read or does not fit the model, a mesh of
// the model is not there, and for what BindModel throws.
void AddModelPoses(const JsonField& field,
                   const std::string& root,
                   const ModelSources& sources,
                   Model model,
                   Scene* scene);

}  // namespace musclewarp
