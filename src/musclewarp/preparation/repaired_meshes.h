// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Reads and repairs the mesh of a bone; all its pieces are kept. Throws
// InputError if it cannot be read or repaired, but a mesh of a model that
// cannot be repaired sets PreparedBone::left_out instead.
PreparedBone RepairBone(PrepareOptions options, const SceneBone& bone);

// Reads, repairs and returns the mesh of a muscle, which is one piece, and
// records all changes to it in `prepared`. Throws InputError if it cannot be
// read or repaired, does not have the size of a muscle (CheckMuscleSize), or
// would lose a named part of its file (CheckNoPartIsLost).
TriangleSoup RepairMuscle(const PrepareOptions& options,
                          const SceneMuscle& muscle,
                          PreparedMuscle* prepared);

}  // namespace musclewarp
