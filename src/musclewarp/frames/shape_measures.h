// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/figures/shape_figures.h"
#include "musclewarp/geometry/surface_deformation.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Measures a muscle with its fine vertices at `points` (n x 3, mm). `before`
// has them in the frame before, or no rows.
ShapeMeasures MeasureShape(const SurfaceAtRest& rest,
                           const Points& points,
                           const Points& before);

}  // namespace musclewarp
