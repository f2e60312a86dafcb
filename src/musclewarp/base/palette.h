// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/base/color.h"

namespace musclewarp {

// The colours of muscles and bones in pictures. The colours of muscles are
// eight reds, pinks and oranges that differ in lightness as well as in hue, so
// that neighbours in number can be told apart by the colour-blind and in grey.
constexpr int kMuscleColors = 8;

// Returns the colour of the muscle with this index; the colours repeat after
// kMuscleColors muscles. Precondition: the index is not negative.
Color MuscleColor(int index);

// Returns the colour of bones, ivory.
Color BoneColor();

}  // namespace musclewarp
