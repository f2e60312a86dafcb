// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace musclewarp {

// Looks for the growth (mm) with which a body has a volume (mm^3): by steps
// that are half as long again until it is too large, and then by false
// position. Stops within two in a thousand of the volume, after 14 steps, or at
// `reach`, the largest growth, if that is not enough; returns the last growth
// that it has tried. `volume_at(t)` grows the body, and may be slow; its result
// rises with t. `left`: the volume without growth, less than `volume`; `t`: the
// growth that is tried first, above 0.
double SearchGrowth(const std::function<double(double)>& volume_at,
                    double left,
                    double volume,
                    double reach,
                    double t);

}  // namespace musclewarp
