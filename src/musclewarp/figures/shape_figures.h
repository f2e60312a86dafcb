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
  double quantile_99 = 1;
  double quantile_999 = 1;
  double largest = 1;
  Eigen::RowVector3d largest_place = Eigen::RowVector3d::Zero();
  double area_beyond_anatomy = 0;
  double area_of_patches = 0;
  double largest_patch = 0;
  Eigen::RowVector3d patch_place = Eigen::RowVector3d::Zero();
};

constexpr auto FieldsOf(Described<StretchMeasures>) {
  using F = StretchMeasures;
  return std::make_tuple(
      Field(&F::mean, "mean").Text("the mean stretch"),
      Field(&F::quantile_99, "quantile_99")
          .Text("99 % of the surface are stretched less"),
      Field(&F::quantile_999, "quantile_999")
          .Text("99.9 % of the surface are stretched less"),
      Field(&F::largest, "largest")
          .Text(
              "of a single triangle; slivers of the mesh at rest are left out"),
      Field(&F::largest_place, "largest_place_mm", "mm").Text("where that is"),
      Field(&F::area_beyond_anatomy, "area_beyond_1_6_mm2", "mm2")
          .Text("area that is stretched to more than 1.6"),
      Field(&F::area_of_patches, "area_beyond_2_mm2", "mm2")
          .Text("area that is stretched to more than 2"),
      Field(&F::largest_patch, "largest_patch_mm2", "mm2")
          .Text("the largest connected area beyond 2. A single triangle is a "
                "patch, too: where `largest` is large and this is small, "
                "single triangles are drawn out, not the muscle"),
      Field(&F::patch_place, "patch_place_mm", "mm").Text("where that is"));
}

// What a frame does to the shape of a muscle, at the fine vertices where it is
// largest. A frame that holds its certificate can still be beyond anatomy;
// these figures show it.
struct ShapeMeasures {
  double max_stretch = 1;
  double max_stretch_along = 1;
  double max_stretch_across = 1;
  Eigen::RowVector3d stretch_place = Eigen::RowVector3d::Zero();
  StretchMeasures triangles;
  double min_area_ratio = 1;
  double max_area_ratio = 1;
  double max_bend = 0;  // degrees
  Eigen::RowVector3d bend_place = Eigen::RowVector3d::Zero();
  double max_change = 0;
  Eigen::RowVector3d change_place = Eigen::RowVector3d::Zero();
};

constexpr auto FieldsOf(Described<ShapeMeasures>) {
  using F = ShapeMeasures;
  return std::make_tuple(
      Field(&F::max_stretch, "max_stretch")
          .Text("the largest ratio of a length on the surface to that at rest, "
                "in any direction (`geometry/surface_deformation.h`)"),
      Field(&F::max_stretch_along, "max_stretch_along")
          .Text("the same along the muscle's nearest line"),
      Field(&F::max_stretch_across, "max_stretch_across")
          .Text("the same across that line"),
      Field(&F::stretch_place, "stretch_place_mm", "mm")
          .Text("where `max_stretch` is"),
      Field(&F::min_area_ratio, "min_area_ratio")
          .Text("the smallest ratio of an area to that at rest"),
      Field(&F::max_area_ratio, "max_area_ratio").Text("the largest"),
      Field(&F::max_bend, "max_bend_deg", "deg")
          .Text("the largest change of the angle between the normals of "
                "neighbouring vertices. At the rims of thin parts normals "
                "point apart by nearly 180 degrees, so that values near 360 "
                "are a rim that turns over, which harms nothing"),
      Field(&F::bend_place, "bend_place_mm", "mm").Text("where that is"),
      Field(&F::max_change, "max_change_mm", "mm")
          .Text("the largest distance of a vertex from its place in the frame "
                "before; in the first frame of a motion from rest; 0 for poses "
                "that are reached on their own"),
      Field(&F::change_place, "change_place_mm", "mm").Text("where that is"),
      Field(&F::triangles, "triangle_stretch")
          .Text("the stretches of triangles, by their areas at rest "
                "(`frames/triangle_stretch.h`)"));
}

// A connected part of a surface.
struct SurfacePatch {
  double area = 0;                                        // mm^2
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();  // its centre, mm
};

// The deviation of an attachment area from its position on its body.
struct AttachmentDrift {
  std::string body;
  int vertices = 0;
  double mean = 0, max = 0;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();
};

constexpr auto FieldsOf(Described<AttachmentDrift>) {
  using F = AttachmentDrift;
  return std::make_tuple(
      Field(&F::body, "body").Text("the body or soft part that it is on"),
      Field(&F::vertices, "vertices")
          .Text("how many vertices it has")
          .AtLeast(0),
      Field(&F::mean, "mean_drift_mm", "mm")
          .Text("the mean distance of its vertices from where the body has "
                "them; with `{contact}=certified` from where they were at rest "
                "once nothing crossed"),
      Field(&F::max, "max_drift_mm", "mm")
          .Text("the largest of these distances"),
      Field(&F::place, "place_mm", "mm").Text("where that is"));
}

}  // namespace musclewarp
