// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/frames/frame.h"

namespace musclewarp {

// Multiplies all lengths of a frame by a factor above 0, areas and energies by
// its square: meshes, lines, gaps, depths, places, moment arms. Sentences stay.
// A power of two is exact.
void ScaleLengths(double factor, Frame* frame);

}  // namespace musclewarp
