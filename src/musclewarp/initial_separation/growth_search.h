// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace musclewarp {

// A growth, mm, and the volume that growth gives a body there, mm^3 per mm, as
// far as it is known: 0 if it is not.
struct GrowthGuess {
  double t = 0;
  double slope = 0;
};

// Looks for the growth with which a body has a volume (mm^3). It tries `first`,
// whose t is above 0, and then what its slope says, if it is known: otherwise
// steps that are half as long again until the volume is too large, and then
// false position. Stops within two in a thousand of the volume, after 14 steps,
// or at `reach`, the largest growth (mm), if that is not enough; returns the
// last growth that it has tried, with the slope of the last two.
// `volume_at(t)` grows the body, and may be slow; its result rises with t.
// `left`: the volume without growth, less than `volume`.
GrowthGuess SearchGrowth(const std::function<double(double)>& volume_at,
                         double left,
                         double volume,
                         double reach,
                         const GrowthGuess& first);

}  // namespace musclewarp
