// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Marks the meshes whose files state another coordinate system than the rest of
// the scene (FindCommonSpace, with the axes of the scene if it states them), so
// that reading converts them, and adds warnings to the scene. Bones that a
// model places are left alone. Unreadable files are ignored. A scene that does
// not state its axes gets those of its files.
void BringIntoOneSpace(Scene* scene);

}  // namespace musclewarp
