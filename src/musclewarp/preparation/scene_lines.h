// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "musclewarp/fibres/continued_lines.h"
#include "musclewarp/preparation/surroundings.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Returns true if a muscle of the scene has no lines.
bool LacksLines(const Scene& scene);

// Makes `lines_each` lines for each muscle of a scene that has none (MakeLines)
// and continues them through the soft parts on which these muscles end
// (ContinueLines). `surroundings` has the repaired meshes of the scene. Returns
// the continued lines of each muscle, and none for muscles with lines of their
// own. `on_item`, which may be empty, is called on the calling thread with the
// number of a muscle before its lines are made, and of the finished muscles
// (ParallelFor). Throws InputError as MakeLines does.
std::vector<ContinuedLines> MakeSceneLines(
    const Surroundings& surroundings,
    int lines_each,
    const std::function<void(size_t m, size_t done)>& on_item,
    const Scene& scene);

}  // namespace musclewarp
