// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"

namespace musclewarp {

// Muscles of which each pushes the next one, as there is no room for it: a bone
// that is 6 mm deep in the first one, which is 2 mm deep in the second one,
// justifies that contact moves the second one by as much as 8 mm.
struct PushChain {
  double depth = 0;          // the depths of all overlaps together, mm
  std::vector<int> muscles;  // from the first to the one that is pushed
};

// Returns for each muscle the chain that may push it farthest: the deepest
// overlap of its first muscle, and those between muscles that follow each
// other. Muscles that only touch pass a push on without adding to it. A chain
// has each muscle at most once, and no more than `max_length` of them; the
// shortest one is the muscle itself, with its own deepest overlap.
//
// `overlaps`: of the shapes without contact. `touching`: pairs of muscles that
// lie on each other with contact.
std::vector<PushChain> FarthestPushes(
    int num_muscles,
    const std::vector<PairDepth>& overlaps,
    const std::vector<std::pair<int, int>>& touching,
    int max_length = 4);

}  // namespace musclewarp
