// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/phantom/phantom_scene.h"

namespace musclewarp {

// The embedded scene "hip": pelvis, femur, two gluteal fans and a psoas of a
// made-up right hip, moved by the femur (data/phantom/README.md).
PhantomScene MakeHipScene(uint32_t seed);

}  // namespace musclewarp
