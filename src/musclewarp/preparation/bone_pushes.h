// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/solver/bone_push_options.h"

namespace musclewarp {

// Sets MuscleModel::bone_push of all muscles, so that bones push them aside
// (WithPushes), if that is enabled. The time adds to that of the preparation.
void AddBonePushes(const BonePushOptions& options, PreparedScene* scene);

}  // namespace musclewarp
