// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

#include "musclewarp/base/described.h"

namespace musclewarp {

// How far a surface is stretched, triangle by triangle, as ratios of lengths to
// those at rest (frames/triangle_stretch.h). Triangles count by their areas at
// rest. A patch is a connected set of triangles beyond kStretchOfPatches, which
// may be a single triangle: where the largest stretch is large and the largest
// patch small, single triangles are drawn out and not the muscle.
struct StretchMeasures {
  double mean = 1;
  double quantile_99 = 1;   // 99 % of the area is stretched less
  double quantile_999 = 1;  // 99.9 %
  double largest = 1;
  Eigen::RowVector3d largest_place = Eigen::RowVector3d::Zero();  // mm
  double area_beyond_anatomy = 0;                                 // mm^2
  double area_of_patches = 0;                                     // mm^2
  double largest_patch = 0;                                       // mm^2
  Eigen::RowVector3d patch_place = Eigen::RowVector3d::Zero();    // mm
};

constexpr auto FieldsOf(Described<StretchMeasures>) {
  using F = StretchMeasures;
  return std::make_tuple(
      Field(&F::mean, "mean", "", "the mean stretch"),
      Field(&F::quantile_99,
            "quantile_99",
            "",
            "99 % of the surface are stretched less"),
      Field(&F::quantile_999,
            "quantile_999",
            "",
            "99.9 % of the surface are stretched less"),
      Field(&F::largest,
            "largest",
            "",
            "of a single triangle; slivers of the mesh at rest are left out"),
      Field(&F::largest_place, "largest_place_mm", "mm", "where that is"),
      Field(&F::area_beyond_anatomy,
            "area_beyond_1_6_mm2",
            "mm2",
            "area that is stretched to more than 1.6"),
      Field(&F::area_of_patches,
            "area_beyond_2_mm2",
            "mm2",
            "area that is stretched to more than 2"),
      Field(&F::largest_patch,
            "largest_patch_mm2",
            "mm2",
            "the largest connected area beyond 2. A single triangle is a "
            "patch, too: where `largest` is large and this is small, single "
            "triangles are drawn out, not the muscle"),
      Field(&F::patch_place, "patch_place_mm", "mm", "where that is"));
}

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
  // stretched too far.
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

constexpr auto FieldsOf(Described<ShapeMeasures>) {
  using F = ShapeMeasures;
  return std::make_tuple(
      Field(&F::max_stretch,
            "max_stretch",
            "",
            "the largest ratio of a length on the surface to that at rest, in "
            "any direction (`geometry/surface_deformation.h`)"),
      Field(&F::max_stretch_along,
            "max_stretch_along",
            "",
            "the same along the muscle's nearest line"),
      Field(&F::max_stretch_across,
            "max_stretch_across",
            "",
            "the same across that line"),
      Field(&F::stretch_place,
            "stretch_place_mm",
            "mm",
            "where `max_stretch` is"),
      Field(&F::min_area_ratio,
            "min_area_ratio",
            "",
            "the smallest ratio of an area to that at rest"),
      Field(&F::max_area_ratio, "max_area_ratio", "", "the largest"),
      Field(&F::max_bend,
            "max_bend_deg",
            "deg",
            "the largest change of the angle between the normals of "
            "neighbouring vertices. At the rims of thin parts normals point "
            "apart by nearly 180 degrees, so that values near 360 are a rim "
            "that turns over, which harms nothing"),
      Field(&F::bend_place, "bend_place_mm", "mm", "where that is"),
      Field(&F::max_change,
            "max_change_mm",
            "mm",
            "the largest distance of a vertex from its place in the frame "
            "before; in the first frame of a motion from rest; 0 for poses "
            "that are reached on their own"),
      Field(&F::change_place, "change_place_mm", "mm", "where that is"),
      Field(&F::triangles,
            "triangle_stretch",
            "",
            "the stretches of triangles, by their areas at rest "
            "(`frames/triangle_stretch.h`)"));
}

// A connected part of a surface.
struct SurfacePatch {
  double area = 0;                                        // mm^2
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();  // its centre, mm
};

// The deviation of an attachment area from its position on its body.
struct AttachmentDrift {
  std::string body;  // or the soft part
  int vertices = 0;
  double mean = 0, max = 0;  // of the distances of its vertices, mm
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();  // of the farthest one
};

constexpr auto FieldsOf(Described<AttachmentDrift>) {
  using F = AttachmentDrift;
  return std::make_tuple(
      Field(&F::body, "body", "", "the body or soft part that it is on"),
      Field(&F::vertices, "vertices", "", "how many vertices it has")
          .AtLeast(0),
      Field(&F::mean,
            "mean_drift_mm",
            "mm",
            "the mean distance of its vertices from where the body has them; "
            "with `--contact=certified` from where they were at rest once "
            "nothing crossed"),
      Field(&F::max, "max_drift_mm", "mm", "the largest of these distances"),
      Field(&F::place, "place_mm", "mm", "where that is"));
}

}  // namespace musclewarp
