// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/palette.h"

#include <array>

namespace musclewarp {

Color MuscleColor(int index) {
  static constexpr std::array<Color, kMuscleColors> kColors = {{
      {0xcc, 0x44, 0x48},  // red
      {0xeb, 0xb6, 0x87},  // peach
      {0x79, 0x27, 0x3b},  // wine
      {0xc5, 0x81, 0x25},  // ochre
      {0xe5, 0x78, 0x8f},  // pink
      {0xb8, 0x42, 0x68},  // rose
      {0x68, 0x47, 0x1e},  // brown
      {0xf2, 0xd7, 0x81},  // straw
  }};
  return kColors[index % kMuscleColors];
}

Color BoneColor() { return {0xef, 0xe6, 0xcf}; }

}  // namespace musclewarp
