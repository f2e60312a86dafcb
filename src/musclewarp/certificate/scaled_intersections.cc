// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/scaled_intersections.h"

namespace musclewarp {

void ScaleLengths(double factor, SceneIntersections* intersections) {
  intersections->max_depth_mm *= factor;
  for (PairIntersection& pair : intersections->pairs) {
    pair.max_depth_mm *= factor;
    pair.place *= factor;
  }
  for (MeshGap& gap : intersections->gaps) {
    gap.at_least_mm *= factor;
    gap.at_most_mm *= factor;
    gap.place *= factor;
  }
}

void ScaleLengths(double factor, DeliveredCrossing* crossing) {
  crossing->place *= factor;
}

void ScaleLengths(double factor, BoneOverlap* overlap) {
  overlap->depth_mm *= factor;
  overlap->place *= factor;
}

}  // namespace musclewarp
