// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Sets MuscleModel::bone_push of all muscles. Must be called whenever models
// have been prepared or read.
void AddBonePushes(PreparedScene* scene);

}  // namespace musclewarp
