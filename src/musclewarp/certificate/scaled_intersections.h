// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/certificate/bone_overlaps.h"
#include "musclewarp/certificate/delivered_crossings.h"
#include "musclewarp/certificate/scene_intersections.h"

namespace musclewarp {

// Multiply all depths, gaps and places by a factor above 0. By a power of two
// that is exact, so that what is proved of gaps stays proved.
void ScaleLengths(double factor, SceneIntersections* intersections);
void ScaleLengths(double factor, DeliveredCrossing* crossing);
void ScaleLengths(double factor, BoneOverlap* overlap);

}  // namespace musclewarp
