// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/opensim/model.h"
#include "musclewarp/scene/json_fields.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Puts a scene whose muscles and bones are read onto its model, fills in the
// lines and bones that are the model's, and takes the poses from the motion.
// `field` is the scene file. Throws InputError.
void AddModelPoses(const JsonField& field,
                   Model model,
                   const std::string& motion_path,
                   Scene* scene);

}  // namespace musclewarp
