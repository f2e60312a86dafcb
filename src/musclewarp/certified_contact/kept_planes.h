// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/half_space.h"

namespace musclewarp {

// A triangle of a muscle near a bone, whose planes stay where they are in the
// frame of the bone at rest, as long as the triangle hardly moves there.
struct GuardedTriangle {
  int triangle = -1;
  Corners corners;  // when its planes were found, in the frame of the bone, mm
  double radius = 0;  // all of the bone within `radius` of `corners` is behind
                      // one of the planes, mm
  int first_space = 0, num_spaces = 0;  // in KeptPlanes::spaces
};

// What is known of the distance of a muscle from a bone. It saves searches and
// changes no result, so that it need not be stored.
struct Clearances {
  Points places;  // #V x 3: the vertices in the frame of the bone at rest, mm

  // By triangle, at these places: a lower bound of its distance from the bone,
  // mm, or -1 for a guarded triangle.
  std::vector<double> distances;
};

// The planes that a bone keeps against a muscle from step to step, in the frame
// of the bone at rest.
struct KeptPlanes {
  std::vector<GuardedTriangle> triangles;  // in rising order
  std::vector<HalfSpace> spaces;
  Clearances clearances;
};

// By muscle and bone: planes of bone b against muscle i are at i * #bones + b.
using KeptBonePlanes = std::vector<KeptPlanes>;

}  // namespace musclewarp
