// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/shape_measures.h"

#include <gtest/gtest.h>

#include "musclewarp/solver/muscle_course.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

// Ratios of lengths of about 1 mm between points at 100 mm.
constexpr double kRatioRounding = 1e-11;

SurfaceAtRest RestOf(const MuscleModel& model) {
  return SurfaceAtRest(model.fine_rest, model.fine_triangles, CourseOf(model));
}

TEST(MeasureShape, ATranslationChangesNothingButThePlace) {
  const PreparedScene scene = PreparedSmallScene();
  const MuscleModel& model = scene.muscles[0].model;
  const Eigen::RowVector3d move(3, -4, 12);
  const Points moved = model.fine_rest.rowwise() + move;
  const ShapeMeasures shape =
      MeasureShape(RestOf(model), moved, model.fine_rest);
  EXPECT_NEAR(shape.max_stretch, 1, kRatioRounding);
  EXPECT_NEAR(shape.min_area_ratio, 1, kRatioRounding);
  EXPECT_NEAR(shape.max_bend, 0, 1e-6);
  EXPECT_NEAR(shape.max_change, 13, 1e-12);
  EXPECT_EQ(MeasureShape(RestOf(model), moved, Points()).max_change, 0);
}

TEST(MeasureShape, StretchAlongTheLineIsNotAcrossIt) {
  const PreparedScene scene = PreparedSmallScene();
  const MuscleModel& model = scene.muscles[0].model;
  const Points& line = model.lines[0].rest;
  const Eigen::Vector3d along =
      (line.row(line.rows() - 1) - line.row(0)).transpose().normalized();
  const Eigen::Matrix3d stretch =
      Eigen::Matrix3d::Identity() + 0.3 * along * along.transpose();
  const ShapeMeasures shape =
      MeasureShape(RestOf(model), model.fine_rest * stretch, model.fine_rest);
  // Where the surface runs along the line it is stretched by 1.3, and nowhere
  // more.
  EXPECT_LE(shape.max_stretch, 1.3 + kRatioRounding);
  EXPECT_NEAR(shape.max_stretch_along, 1.3, 0.01);
  EXPECT_LE(shape.max_area_ratio, 1.3 + kRatioRounding);
  EXPECT_GE(shape.min_area_ratio, 1 - kRatioRounding);
  EXPECT_LT(shape.max_stretch_across, 1.05);
}

}  // namespace
}  // namespace musclewarp
