// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Sets MuscleModel::bone_push of all muscles, so that bones push them aside
// (WithPushes). The time adds to that of the preparation.
void AddBonePushes(PreparedScene* scene);

}  // namespace musclewarp
