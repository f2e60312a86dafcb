// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "musclewarp/initial_separation/cell_surface.h"
#include "musclewarp/initial_separation/growth_search.h"

namespace musclewarp {

class GrowingBody;

// The surface of a muscle that has lost a part of its volume to bones or other
// muscles. It grows on its free sides, next to where it was cut. `body` is the
// result of CellSurface(); at its cuts, the surface of the body lies within the
// muscle. It grows by
//
//   growth(p) = max(0, t - d(p) / 3),
//
// where d(p) is the distance to the cuts (mm). The body grows only within its
// medial cell, and only where no bone or other muscle is in the way. A body
// without cuts, which lost volume only by sampling, grows uniformly.
//
//   SurfaceGrowth growth(options, body, muscle, others, bones, volume);
//   const TriangleSoup surface = growth.UpTo(volume);
//
// Distances are cached and reused by later calls of UpTo().
class SurfaceGrowth {
 public:
  // `volume`: the volume of the muscle before its loss, mm^3; it bounds t.
  // `muscle`, `others` and `bones` must outlive this object. Preconditions
  // (CHECKed): the options are valid, the body has triangles.
  SurfaceGrowth(const CellSurfaceOptions& options,
                const TriangleSoup& body,
                const SolidDistance& muscle,
                const std::vector<const SolidDistance*>& others,
                const std::vector<const SolidDistance*>& bones,
                double volume);
  ~SurfaceGrowth();

  // Returns the body with the smallest t that gives it `volume` (mm^3), or
  // grown as far as it can. The surface has the properties of CellSurface().
  TriangleSoup UpTo(double volume);

 private:
  double spacing_;    // mm
  double left_;       // volume without growth, mm^3
  double reach_;      // the largest t, mm
  GrowthGuess last_;  // what the last search found
  std::unique_ptr<GrowingBody> body_;
};

}  // namespace musclewarp
