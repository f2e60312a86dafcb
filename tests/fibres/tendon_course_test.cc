// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/tendon_course.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/fibres/distance_outside.h"
#include "musclewarp/skeleton/polyline.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

Points CornersAt(const std::vector<Eigen::RowVector3d>& rows) {
  Points corners(static_cast<Eigen::Index>(rows.size()), 3);
  for (size_t i = 0; i < rows.size(); ++i) corners.row(i) = rows[i];
  return corners;
}

TEST(TendonCourse, IsStraightWhereNoBoneIs) {
  const Points course = TendonCourse(CornersAt({{0, 0, 0}, {0, 0, 95}}), {});
  EXPECT_EQ(course.row(0), Eigen::RowVector3d(0, 0, 0));
  EXPECT_EQ(course.row(course.rows() - 1), Eigen::RowVector3d(0, 0, 95));
  EXPECT_NEAR(PolylineLength(course), 95, 1e-9);
  EXPECT_NEAR(course(1, 2), 10, 1);  // points every 10 mm
}

TEST(TendonCourse, GoesRoundABoneAsAThreadDoes) {
  const TriangleSoup ball = SphereAt({0, 0, 0}, 30, 5);
  const TriangleBvh bone(ball.points, ball.triangles);
  const Points course =
      TendonCourse(CornersAt({{-80, 0, 10}, {80, 0, 10}}), {&bone});
  // Two tangents and an arc of the circle 3 mm outside of the ball.
  const double radius = 30 + kTendonClearance;
  const double from_middle = std::hypot(80.0, 10.0);
  const double tangent = std::sqrt(from_middle * from_middle - radius * radius);
  const double arc = radius * (2 * std::atan2(80.0, 10.0) -
                               2 * std::acos(radius / from_middle));
  // Chords of 10 mm are shorter than the arc by less than 1 %.
  EXPECT_NEAR(PolylineLength(course), 2 * tangent + arc, 2);
  for (const auto& point : course.rowwise()) {
    EXPECT_GT(PlaceBesideMeshes({&bone}, point).distance, kTendonClearance - 1);
  }
}

TEST(TendonCourse, PassesItsCorners) {
  const Eigen::RowVector3d pulley(0, 20, 60);
  const Points course =
      TendonCourse(CornersAt({{0, 0, 0}, pulley, {50, 20, 60}}), {});
  // The points of the course are 10 mm apart, so that a corner is cut by less
  // than half of that.
  EXPECT_LT((course.rowwise() - pulley).rowwise().norm().minCoeff(), 5);
  EXPECT_NEAR(PolylineLength(course), std::hypot(20.0, 60.0) + 50, 3);
}

}  // namespace
}  // namespace musclewarp
