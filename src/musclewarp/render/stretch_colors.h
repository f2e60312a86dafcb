// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/base/color.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/render/picture.h"

namespace musclewarp {

// Colours for the stretch of surfaces, none of them that of bones: light where
// they are as at rest, dark where no muscle could bear it. They are told apart
// by lightness alone.

// Returns the colour of each triangle, #F, by its largest stretch in any
// direction. `rest` and `deformed`: #V x 3, mm.
std::vector<Color> StretchColors(const Points& rest,
                                 const Points& deformed,
                                 const Triangles& triangles);

// Returns the meaning of the colours.
std::vector<LegendEntry> StretchLegend();

}  // namespace musclewarp
