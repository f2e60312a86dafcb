// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/initial_separation/distance_samples.h"
#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the boundary of the region in which a function is negative: one or
// several closed, outward oriented surfaces that do not cross themselves (mm).
//
// The function is sampled at the multiples of `spacing` (mm) in the box, and
// interpolated linearly in six tetrahedra per lattice cell. Hence the surfaces
// of two regions with the same spacing do not cross if the sum of the two
// functions is positive everywhere, however coarse the sampling is. Parts
// thinner than the spacing may be lost. The function is called from several
// threads.
//
// Preconditions: the spacing is above zero (CHECKed), and the function is
// positive outside the box.
TriangleSoup MarchingTetrahedra(const SignedDistanceFunction& distance,
                                const Box3& box,
                                double spacing);

}  // namespace musclewarp
