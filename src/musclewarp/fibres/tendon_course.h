// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// How far the middle of a tendon stays off bones, mm: half of its thickness.
constexpr double kTendonClearance = 3;

// Returns the course of a tendon without a mesh: the shortest way near the
// polyline `corners` (#C x 3, mm) that passes all its points and stays
// kTendonClearance off the closed meshes `bones`, less near its ends, which may
// lie on them; #P x 3, mm, with neighbours some 10 mm apart. Precondition
// (CHECKed): there are at least two corners, and neighbours are distinct.
Points TendonCourse(const Points& corners,
                    const std::vector<const TriangleBvh*>& bones);

}  // namespace musclewarp
