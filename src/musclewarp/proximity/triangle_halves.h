// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// How trees and groups of triangles are made: by halves, and halves of these.

// Returns the centroids of triangles, #F x 3. `points`: #V x 3.
Points CentroidsOf(const Points& points, const Triangles& triangles);

// Reorders the numbers of points (rows of `points`, #P x 3, such as centroids)
// in [begin, end) along the longest side of the box around these points: none
// before `middle` is beyond any that follows it. Ties go to the smaller number,
// so that the result does not depend on the standard library. Precondition:
// begin < middle < end.
void SplitAlongLongestSide(const Points& points,
                           int* begin,
                           int* middle,
                           int* end);

}  // namespace musclewarp
