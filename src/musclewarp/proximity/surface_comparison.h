// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct SurfaceComparisonOptions {
  // Surfaces are sampled at places at most this far apart, mm. 0 stands for the
  // diagonal of the box around both meshes over 300.
  double spacing = 0;

  // About so many points of a regular grid lie in the larger of the two bodies.
  // The overlap of their volumes is counted on them; its error is about the
  // surface in cells of the grid over their number.
  int grid_points = 100000;

  // Returns false and names the field, its value and the rule if a field is out
  // of range.
  bool IsValid(std::string* error) const;
};

// The distances of the places of one surface from another, weighted by area.
struct SurfaceDistances {
  double mean = 0;              // mm
  double root_mean_square = 0;  // mm
  double percentile_95 = 0;     // mm: 95 per cent of the area is nearer

  // Of all places, mm. With places at most `spacing` apart the true largest
  // distance, the one-sided Hausdorff distance, is larger by at most that.
  double largest = 0;

  // The mean of the distances with a sign, mm: negative inside the other body.
  double signed_mean = 0;
};

// How far two closed surfaces are from being one.
struct SurfaceComparison {
  SurfaceDistances a_to_b, b_to_a;

  // Of all places of both, so that it does not depend on the order. Its
  // signed_mean has no meaning.
  SurfaceDistances symmetric;
  double spacing = 0;  // mm, as used

  double volume_a = 0, volume_b = 0;  // mm^3

  // The volume that both share, over the mean of both (Dice) and over that of
  // their union (Jaccard).
  double dice = 0, jaccard = 0;
  double grid_spacing = 0;  // mm, as used

  // The distance of each vertex of A from B, mm, negative inside B.
  Eigen::VectorXd vertex_distances;
};

// Returns at how many places a surface is compared, which is what time and
// memory grow with. Precondition: spacing is above 0, mm.
double NumSamples(const TriangleSoup& mesh, double spacing);

// Compares two surfaces, both closed and oriented outward, in mm and in the
// same frame. The result is the same on every machine. Preconditions (CHECKed):
// the options are valid, and neither mesh is empty.
SurfaceComparison CompareSurfaces(const TriangleSoup& a,
                                  const TriangleSoup& b,
                                  const SurfaceComparisonOptions& options);

}  // namespace musclewarp
