// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/initial_separation/cell_surface.h"

namespace musclewarp {

// Returns a body of a muscle that lost a part of its volume to bones or other
// muscles, grown until it holds `volume` (mm^3): what was cut off comes back on
// the free sides, next to where it was. `body` is what CellSurface() has left;
// where it was cut its surface lies within the muscle. It grows by
//
//   growth(p) = max(0, t - d(p) / 3),
//
// d(p) being the distance to where it was cut (mm), as far as its medial cell
// reaches and no bone or other muscle is in the way, with the least t that
// gives the volume. A body that was cut nowhere, and lost its volume to the
// samples of its surface, grows evenly. The surface is as that of
// CellSurface(), and has less than the volume if it cannot grow so far.
// Preconditions (CHECKed): the options are valid, the body has triangles.
TriangleSoup GrownSurface(const CellSurfaceOptions& options,
                          const TriangleSoup& body,
                          const SolidDistance& muscle,
                          const std::vector<const SolidDistance*>& others,
                          const std::vector<const SolidDistance*>& bones,
                          double volume);

}  // namespace musclewarp
