// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Adds what the preparation found to the warnings of a scene, one sentence
// each, and logs all of them.
void AddSceneWarnings(const PrepareOptions& options, PreparedScene* prepared);

}  // namespace musclewarp
