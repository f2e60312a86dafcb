// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "musclewarp/phantom/phantom_scene.h"

namespace musclewarp {

// Makes the scene "random": an anatomy that is nobody's, drawn from the seed.
// It tests contact on shapes that nobody chose. It has two to six bones, each
// with a body of its own; 2 to 20 muscles that run from bone to bone over other
// bones and muscles, and overlap with both by up to 6 mm; and a motion of three
// to five poses.
//
//   const PhantomScene scene = MakeRandomScene(17, 0);
//
// The scene is sane: meshes are closed manifolds that do not cross themselves,
// at least half of the volume of a muscle is outside bones, bones do not cross
// each other in any pose. Whether contact can be solved is not tested.
//
// `num_muscles` fixes the number of muscles, 2 to 32; with 0 it is drawn from 2
// to 20. A larger number gives the same bones and the same first muscles, with
// more after them, unless so many find no room at these bones. `num_poses`
// fixes the number of poses of the same motion (see DrawPoses).
PhantomScene MakeRandomScene(uint32_t seed, int num_muscles, int num_poses = 0);

}  // namespace musclewarp
