// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/render/image.h"

namespace musclewarp {

// The colour of the i-th muscle: eight reds, pinks and oranges, then again
// from the start. They differ in lightness as well as hue, so that neighbours
// in number stay apart for the colour-blind and in grey.
Color MuscleColor(int index);
constexpr int kMuscleColors = 8;

// Ivory.
Color BoneColor();

}  // namespace musclewarp
