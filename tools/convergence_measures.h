// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Places on a surface, each in a triangle, and how far the points that they
// were looked up for are away.
struct SurfacePlaces {
  std::vector<int> triangles;   // #places
  Points barycentric;           // #places x 3, weights of the corners
  double largest_distance = 0;  // of a point from its place, mm
};

// Finds the place of a surface that is nearest to each vertex of another, among
// triangles that face the way the vertex does: in a thin muscle those of the
// other side are near, too. Precondition: both surfaces have triangles.
SurfacePlaces NearestPlaces(const TriangleSoup& surface,
                            const TriangleSoup& from);

// Returns a field that is given at the vertices of a surface (#V x 3) at places
// on it, interpolated linearly: #places x 3.
Points FieldAt(const SurfacePlaces& places,
               const Triangles& triangles,
               const Points& field);

// How a surface is stretched (SurfaceDeformation::largest_stretch), as ratios
// of lengths; each vertex counts by a third of the area of its triangles at
// rest.
struct StretchSummary {
  double mean = 1;
  double percentile_99 = 1;
  double percentile_999 = 1;  // 99.9 %
  double largest = 1;
};

// Summarises the stretch of a surface whose vertices have moved to `deformed`
// (#V x 3, mm).
StretchSummary SummariseStretch(const TriangleSoup& rest,
                                const Points& deformed);

// Returns the smallest of the values that at least `fraction` of the weight
// does not exceed. Preconditions (CHECKed): there are values, and as many
// weights.
double WeightedQuantile(const Eigen::VectorXd& values,
                        const Eigen::VectorXd& weights,
                        double fraction);

}  // namespace musclewarp
