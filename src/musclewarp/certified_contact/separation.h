// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/geometry/half_space.h"
#include "musclewarp/geometry/triangle_bvh.h"

namespace musclewarp {

// Adds to `spaces` half-spaces whose common part does not meet any of the
// `num_near` triangles `near` of `obstacles` that are within `radius` of
// `triangle`; all of them keep at least three quarters of `gap` from it. Where
// `triangle` is farther away than `gap` from all obstacles it lies in all of
// them, and they leave it half the room beyond.
//
// Found as in Deits & Tedrake, "Computing large convex regions of obstacle-free
// space through semidefinite programming", 2014, with a triangle in place of
// the ellipsoid: the nearest obstacle gives a plane, and all that lies behind
// it, or higher by no more than a quarter of the gap, needs no other.
//
// Precondition: `triangle` crosses none of the obstacles. Of one that it
// touches or crosses nothing is said.
void PartFromObstacles(const Corners& triangle,
                       const TriangleBvh& obstacles,
                       const int* near,
                       int num_near,
                       double radius,
                       double gap,
                       std::vector<HalfSpace>* spaces);

// Two triangles near each other and the direction that parts them.
struct PartedPair {
  int a = -1;
  int b = -1;
  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();  // from b to a
  double distance = 0;                                     // mm
};

// How two triangles are parted, but for their numbers; false if they touch or
// cross. In the other order the same to the bit, with the normal reversed.
bool Part(const Corners& a, const Corners& b, PartedPair* pair);

// The pairs of a triangle of a and one of b that are not farther from each
// other than `radius`, where they are or where they are in the moved trees; as
// they are parted where they are. Pairs that touch or cross there are left out.
// In an order that depends on the meshes only. a and b may be the same.
std::vector<PartedPair> PartedPairs(const TriangleBvh& a,
                                    const TriangleBvh& b,
                                    const TriangleBvh& moved_a,
                                    const TriangleBvh& moved_b,
                                    double radius);

}  // namespace musclewarp
