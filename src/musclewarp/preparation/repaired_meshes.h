// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Reads and repairs the mesh of a bone, of which all pieces stay. Throws
// InputError for what cannot be read or repaired, but for a mesh of a model
// that cannot be repaired: that has PreparedBone::left_out.
PreparedBone RepairBone(PrepareOptions options, const SceneBone& bone);

// Reads and repairs the mesh of a muscle, which is one piece, and returns it;
// what was done to it is set in `prepared`. Throws InputError for what cannot
// be read or repaired, has not the size of a muscle, or would lose a named part
// of its file (CheckNoPartIsLost).
TriangleSoup RepairMuscle(const PrepareOptions& options,
                          const SceneMuscle& muscle,
                          PreparedMuscle* prepared);

}  // namespace musclewarp
