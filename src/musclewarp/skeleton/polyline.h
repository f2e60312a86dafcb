// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// mm; 0 for fewer than two points.
double PolylineLength(const Points& points);

// `count` points at equal distances along a polyline, ends included.
// Preconditions (CHECKed): the polyline has two points, count is at least 2.
Points Resampled(const Points& points, int count);

}  // namespace musclewarp
