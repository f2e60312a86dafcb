// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/phantom/phantom_scene.h"

namespace musclewarp {

// Makes the embedded scene "hip": a right hip that is nobody's, of pelvis,
// femur, two gluteal fans and a psoas, whose muscles the femur moves. It has
// the defects and overlaps of segmented meshes and is what demo.sh deforms; see
// data/phantom/README.md. The seed decides on the bumps of the surfaces and on
// the places of the defects.
PhantomScene MakeHipScene(uint32_t seed);

}  // namespace musclewarp
