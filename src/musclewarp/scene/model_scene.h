// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/model_sources.h"

namespace musclewarp {

struct Scene;

// Places a scene, whose muscles and bones have been read, on its model. Adds
// the data that the scene takes from the model: the rest points of lines that
// are paths of muscles, and the meshes of bones that name none. Makes one pose
// from every row of the motion, which is a file or part of the scene file, or
// from every posture of a design (DesignedPostures).
//
// `field` is the scene file, and paths in it are relative to `root`. Throws
// InputError if the motion cannot be read or does not fit the model, if a mesh
// of the model does not exist, and as BindModel does.
void AddModelPoses(const JsonField& field,
                   const std::string& root,
                   const ModelSources& sources,
                   Model model,
                   Scene* scene);

}  // namespace musclewarp
