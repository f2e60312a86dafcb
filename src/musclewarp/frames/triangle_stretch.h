// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/figures/shape_figures.h"
#include "musclewarp/mesh/triangle.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Stretches beyond which areas of a surface are measured: the first is more
// than muscles and tendons bear, at the second the surface is torn.
constexpr double kStretchBeyondAnatomy = 1.6;
constexpr double kStretchOfPatches = 2;

// Triangles whose smallest height is below this share of their longest edge
// (slivers) say nothing of the stretch of a surface.
constexpr double kSliverAspect = 0.05;

// How much more than without contact a triangle has to be stretched before that
// counts as torn by contact.
constexpr double kStretchByContact = 0.2;

// Returns the smallest height of a triangle as a share of its longest edge; 0
// if its corners coincide.
double AspectOf(const Corners& triangle);

// Returns the largest stretch of a triangle in any direction: the larger
// singular value of its deformation gradient; 1 if it is a sliver at rest.
double StretchOf(const Corners& rest, const Corners& deformed);

// Returns the stretch of each triangle, #F. `rest` and `deformed`: #V x 3, mm.
Eigen::VectorXd TriangleStretches(const Points& rest,
                                  const Points& deformed,
                                  const Triangles& triangles);

// Measures a surface whose vertices have moved from `rest` to `deformed`.
// Places are those of the deformed surface. Precondition: there are triangles.
StretchMeasures MeasureStretch(const Points& rest,
                               const Points& deformed,
                               const Triangles& triangles);

// Returns the largest patch that contact has torn: triangles stretched beyond
// kStretchOfPatches, and by kStretchByContact more than without
// contact. `rest`, `deformed` and `without_contact`: #V x 3, mm. The area is
// that at rest, the place that of the deformed surface. Precondition: there are
// triangles.
SurfacePatch LargestTornPatch(const Points& rest,
                              const Points& deformed,
                              const Points& without_contact,
                              const Triangles& triangles);

// Returns for each of `fractions`, which rise, the smallest of the values that
// at least this fraction of the weight does not exceed. Preconditions
// (CHECKed): there are values, and as many weights.
std::vector<double> WeightedQuantiles(const Eigen::VectorXd& values,
                                      const Eigen::VectorXd& weights,
                                      const std::vector<double>& fractions);

}  // namespace musclewarp
