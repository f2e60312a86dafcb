// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Marks the meshes whose files state another space than the rest of the scene
// (FindCommonSpace, with the axes of the scene if they are stated), so that
// they are turned when they are read, and adds warnings to the scene. Bones
// that a model puts in their places are left alone. Files that cannot be read
// are passed over. A scene that does not state its axes has those of its files.
void BringIntoOneSpace(Scene* scene);

}  // namespace musclewarp
