// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/initial_separation/distance_samples.h"
#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the border of the region where a function is negative, as closed,
// outward oriented surfaces that do not cross themselves, one or several.
//
// The function is sampled at the multiples of `spacing` (mm) in the box, and is
// taken as linear in the six tetrahedra of every cell between them. So two
// regions that are sampled with the same spacing, and whose functions add up to
// something positive everywhere, have surfaces that do not cross, however
// coarse the sampling is. Parts thinner than the spacing may be lost. The
// function is called from several threads.
//
// Preconditions: the spacing is above zero (CHECKed), and the function is
// positive outside the box.
TriangleSoup MarchingTetrahedra(const SignedDistanceFunction& distance,
                                const Box3& box,
                                double spacing);

}  // namespace musclewarp
