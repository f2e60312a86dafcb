// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns both ends (2 x 3, mm) of the long axis of a surface: the line through
// the centre of its area along which the area is spread most, as far as the
// surface goes. It does not depend on how the surface is triangulated. Which
// end comes first is not defined. Precondition: the area is above 0.
Points LongAxis(const Points& points, const Triangles& triangles);

}  // namespace musclewarp
