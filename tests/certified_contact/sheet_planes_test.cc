// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/sheet_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "certified_contact/contact_group.h"

namespace musclewarp {
namespace {

std::vector<SeparatingPlane> SheetPlanesOf(const ContactGroup& group) {
  const ContactStep step =
      MakeContactStep(group.scene, group.state, group.state.targets, {});
  return FindPlanesBetweenSheets({}, step, 0);
}

TEST(FindPlanesBetweenSheets, KeepsTheTwoSidesOfAThinPartApart) {
  // Two triangles above and two below, which share corners with none of them.
  const ContactGroup group({Box(20, 20, 0.5)}, {});
  const std::vector<SeparatingPlane> planes = SheetPlanesOf(group);
  ASSERT_EQ(planes.size(), 4u);
  const Points& points = group.state.points[0];
  for (const SeparatingPlane& plane : planes) {
    EXPECT_TRUE(plane.IsWithinOneMuscle());
    EXPECT_NEAR(std::abs(plane.normal.z()), 1, 1e-12);
    EXPECT_NEAR(plane.distance, 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(plane.half_gap, StepOptions().gap / 2);
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector3d up =
          points.row(plane.above[k]) - points.row(plane.below[0]);
      EXPECT_NEAR(plane.normal.dot(up), 0.5, 1e-12);
    }
  }
}

TEST(FindPlanesBetweenSheets, KeepsTheTwoSidesOfASlitApart) {
  // Two boxes in one mesh, 0.3 mm apart: their front sides face each other.
  const TriangleSoup lower = Box(20, 20, 2);
  const TriangleSoup upper = MovedBy(lower, {0, 0, 2.3});
  const ContactGroup group({Together(lower, upper)}, {});
  const std::vector<SeparatingPlane> planes = SheetPlanesOf(group);
  ASSERT_EQ(planes.size(), 4u);
  for (const SeparatingPlane& plane : planes) {
    EXPECT_NEAR(plane.distance, 0.3, 1e-12);
  }
}

TEST(FindPlanesBetweenSheets, LeavesOutWhatIsThickOrRound) {
  EXPECT_TRUE(SheetPlanesOf(ContactGroup({Box(20, 20, 2)}, {})).empty());
  // Neighbouring triangles are near each other, but do not face each other.
  EXPECT_TRUE(SheetPlanesOf(ContactGroup({Icosphere(5, 4)}, {})).empty());
}

TEST(PlaneBetweenSheets, TakesTheTargetsWhereTheTrianglesWereNotApart) {
  // Flat before the step, so that the upper and the lower side touch.
  ContactGroup group({Box(20, 20, 2)}, {});
  const Points targets = group.state.points[0];
  group.state.points[0].col(2).setZero();
  const ContactStep step =
      MakeContactStep(group.scene, group.state, {targets}, {});
  const Triangles& triangles = group.scene.muscles[0].triangles;
  int pairs = 0;
  for (int f = 0; f < triangles.rows(); ++f) {
    for (int g = 0; g < triangles.rows(); ++g) {
      const auto height = [&](int triangle) -> Eigen::Vector3d {
        return CornersOf(targets, triangles.row(triangle)).col(2);
      };
      if ((height(f).array() < 1).any() || (height(g).array() > -1).any()) {
        continue;
      }
      ++pairs;
      const auto plane = PlaneBetweenSheets({}, step, targets, 0, f, g);
      ASSERT_TRUE(plane.has_value());
      EXPECT_NEAR(plane->normal.z(), 1, 1e-12);
      EXPECT_NEAR(plane->distance, 2, 1e-12);
    }
  }
  EXPECT_EQ(pairs, 4);
}

}  // namespace
}  // namespace musclewarp
