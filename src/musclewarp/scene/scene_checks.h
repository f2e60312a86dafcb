// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// The checks of a scene that concern several of its parts: names are unique,
// bodies that lines, attachments and poses name are bodies of bones, lines have
// at least two points and no repeated neighbours, targets have as many points
// as their line. Throws InputError naming the scene file and the field.
void CheckScene(const Scene& scene);

}  // namespace musclewarp
