// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "musclewarp/joints/cylinder_fit.h"
#include "musclewarp/joints/surface_points.h"

namespace musclewarp {

// The axis of a surface of revolution, and how well the surface is one.
struct RevolutionFit {
  Axis axis;

  // How far the normals pass the axis, mm, as a root mean square over the
  // points that count.
  double spread = 0;

  // The same for the next best axis, at right angles to the first: near the
  // spread itself, the surface is one of revolution about both, as a sphere
  // is, and the axis means nothing.
  double next_spread = 0;
};

// Finds the axis of a surface of revolution, which all its normals meet, by
// minimising the sum of (n . v + (p x n) . u)^2 over the lines (u, v), |u| = 1,
// weighted anew a few times so that normals which pass far from the axis count
// less (Pottmann and Randrup, "Rotational and helical surface approximation for
// reverse engineering", Computing 60, 1998). The point of the axis is the one
// nearest to the mean of the points. Nothing is returned for fewer than six
// points.
std::optional<RevolutionFit> FitRevolution(const SurfacePoints& surface);

}  // namespace musclewarp
