// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/frames/triangle_stretch.h"
#include "musclewarp/geometry/surface_deformation.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// What a frame does to the shape of a muscle, at the fine vertices where it is
// largest. A frame that holds its certificate can still be beyond anatomy;
// these figures show it.
struct ShapeMeasures {
  // Ratios of lengths on the surface to those at rest: in any direction, along
  // the muscle's lines and across them (geometry/surface_deformation.h).
  double max_stretch = 1;
  double max_stretch_along = 1;
  double max_stretch_across = 1;
  Eigen::RowVector3d stretch_place = Eigen::RowVector3d::Zero();  // mm

  // The same by triangles instead of vertices, with the areas that are
  // stretched too far (frames/triangle_stretch.h).
  StretchMeasures triangles;

  // Ratios of areas to those at rest.
  double min_area_ratio = 1;
  double max_area_ratio = 1;

  // Change of the angle between neighbouring normals against rest, degrees.
  double max_bend = 0;
  Eigen::RowVector3d bend_place = Eigen::RowVector3d::Zero();

  // Distance of a vertex from its place in the frame before, mm. 0 if the pose
  // was reached on its own.
  double max_change = 0;
  Eigen::RowVector3d change_place = Eigen::RowVector3d::Zero();
};

// Measures a muscle with its fine vertices at `points` (n x 3, mm). `before`
// has them in the frame before, or no rows.
ShapeMeasures MeasureShape(const SurfaceAtRest& rest,
                           const Points& points,
                           const Points& before);

}  // namespace musclewarp
