// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "musclewarp/preparation/surroundings.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns true if a muscle of the scene has no lines.
bool LacksLines(const Scene& scene);

// Makes `lines_each` lines for each muscle of a scene that has none (MakeLines)
// and continues them through the soft parts on which these muscles end
// (ContinueLines). `surroundings` has the repaired meshes of the scene.
// Returns for each muscle the indices of those through which its lines go on.
// `on_done` is called on the calling thread with the number of muscles that are
// done, and may be empty. Throws InputError as MakeLines does.
std::vector<std::vector<int>> MakeSceneLines(
    const Surroundings& surroundings,
    int lines_each,
    const std::function<void(size_t)>& on_done,
    Scene* scene);

}  // namespace musclewarp
