// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "musclewarp/initial_separation/cell_surface.h"

namespace musclewarp {

class GrowingBody;

// A body of a muscle that lost a part of its volume to bones or other muscles,
// and grows: what was cut off comes back on the free sides, next to where it
// was. `body` is what CellSurface() has left; where it was cut its surface lies
// within the muscle. It grows by
//
//   growth(p) = max(0, t - d(p) / 3),
//
// d(p) being the distance to where it was cut (mm), as far as its medial cell
// reaches and no bone or other muscle is in the way. A body that was cut
// nowhere, and lost its volume to the samples of its surface, grows evenly.
//
//   SurfaceGrowth growth(options, body, muscle, others, bones, volume);
//   const TriangleSoup surface = growth.UpTo(volume);
//
// The distances that a growth asks for are kept for the next one.
class SurfaceGrowth {
 public:
  // `volume`: that which the muscle has lost a part of, mm^3; it bounds t.
  // `muscle`, `others` and `bones` must outlive the growth. Preconditions
  // (CHECKed): the options are valid, the body has triangles.
  SurfaceGrowth(const CellSurfaceOptions& options,
                const TriangleSoup& body,
                const SolidDistance& muscle,
                const std::vector<const SolidDistance*>& others,
                const std::vector<const SolidDistance*>& bones,
                double volume);
  ~SurfaceGrowth();

  // Returns the body with the least t that gives it `volume` (mm^3), or as much
  // of it as it can grow to. The surface is as that of CellSurface().
  TriangleSoup UpTo(double volume);

 private:
  double spacing_;   // mm
  double left_;      // the volume without growth, mm^3
  double reach_;     // the largest t, mm
  double last_ = 0;  // t of the last growth, mm
  std::unique_ptr<GrowingBody> body_;
};

}  // namespace musclewarp
