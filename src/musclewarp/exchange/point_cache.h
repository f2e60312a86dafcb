// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/exchange/animation.h"

namespace musclewarp {

// Writes an animation for Blender's Mesh Cache modifier: for each mesh its rest
// shape as <name>.obj, and the vertices of all frames as <name>.pc2 (Point
// Cache 2, single precision), in metres and with +y up as in .glb files (see
// GltfConversion). Sample i of a cache is the i-th frame of the animation,
// without the rest pose; if the frames are evenly spaced, the head of the cache
// has the number of the first one in the run and the step. One frame at a time
// is in memory.
//
// The folder appears complete or not at all, and replaces one of that name.
// Throws InputError if a frame cannot be read or the folder not be written, or
// if a folder is there that holds anything else than .obj and .pc2 files.
void WritePointCaches(const std::string& dir, const Animation& animation);

}  // namespace musclewarp
