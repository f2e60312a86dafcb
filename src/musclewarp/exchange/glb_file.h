// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/exchange/animation.h"

namespace musclewarp {

// Writes an animation as binary glTF 2.0 (.glb), in metres and with +y up (see
// GltfConversion). The scene has a node for each mesh, by its name and in the
// colours of the pictures, below one node that moves the origin to the middle
// of the meshes, so that single precision is to 1e-4 mm and better. A muscle
// has its rest shape, and a morph target for each frame, named as the folder of
// the frame, which holds the displacements from rest; a bone is an animated
// node. All follow one animation, linear between the frames, whose extras have
// the numbers of the "frames" in the run. There are no normals, so that viewers
// compute those of each frame.
//
// One frame at a time is in memory. The file appears complete or not at all.
// Throws InputError if a frame cannot be read or the file not be written.
void WriteGlb(const std::string& path, const Animation& animation);

}  // namespace musclewarp
