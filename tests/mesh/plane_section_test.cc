// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/plane_section.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "musclewarp/mesh/transformed.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr int kSides = 24;
constexpr double kRadius = 7, kHeight = 40;

// The section of the cylinder below: a regular polygon of 24 corners.
const double kPolygon =
    kSides * kRadius * kRadius * std::sin(2 * M_PI / kSides) / 2;

// Areas are sums of a few dozen products of coordinates.
constexpr double kAreaRounding = 1e-10;

// A cylinder about z from 0 to kHeight, of kSides plane sides.
TriangleSoup Cylinder() {
  TriangleSoup soup;
  soup.points.resize(2 * kSides + 2, 3);
  soup.triangles.resize(4 * kSides, 3);
  const int bottom = 2 * kSides, top = bottom + 1;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * M_PI * i / kSides;
    const double x = kRadius * std::cos(angle), y = kRadius * std::sin(angle);
    const int j = (i + 1) % kSides;
    soup.points.row(i) << x, y, 0;
    soup.points.row(kSides + i) << x, y, kHeight;
    soup.triangles.row(4 * i) << i, j, kSides + j;
    soup.triangles.row(4 * i + 1) << i, kSides + j, kSides + i;
    soup.triangles.row(4 * i + 2) << j, i, bottom;
    soup.triangles.row(4 * i + 3) << kSides + i, kSides + j, top;
  }
  soup.points.row(bottom) << 0, 0, 0;
  soup.points.row(top) << 0, 0, kHeight;
  return soup;
}

double AreaAt(const TriangleSoup& soup,
              const Eigen::RowVector3d& place,
              const Eigen::RowVector3d& normal) {
  return SectionArea(soup.points, soup.triangles, place, normal);
}

TEST(SectionArea, OfACylinderIsItsPolygon) {
  for (const double z : {0.1, 1.0, 20.0, 39.9}) {
    for (const double way : {1.0, -3.0}) {
      EXPECT_NEAR(
          AreaAt(Cylinder(), {1, 2, z}, {0, 0, way}), kPolygon, kAreaRounding);
    }
  }
  EXPECT_EQ(AreaAt(Cylinder(), {0, 0, 41}, {0, 0, 1}), 0);
  EXPECT_EQ(AreaAt(Cylinder(), {0, 0, -1}, {0, 0, 1}), 0);
}

// A tilted plane cuts an area that is larger by the cosine of the tilt.
TEST(SectionArea, GrowsAsThePlaneTilts) {
  const double tilt = 0.7;
  const Eigen::RowVector3d normal(std::sin(tilt), 0, std::cos(tilt));
  EXPECT_NEAR(AreaAt(Cylinder(), {0, 0, 20}, normal),
              kPolygon / std::cos(tilt),
              kAreaRounding);
}

TEST(SectionArea, ScalesWithTheSquareOfLengths) {
  TriangleSoup larger = Spindle(8, 40, 3);
  const Eigen::RowVector3d place(1, 2, 5), normal(0.1, 0.2, 1);
  const double area = AreaAt(larger, place, normal);
  larger.points *= 3;
  EXPECT_NEAR(AreaAt(larger, 3 * place, normal), 9 * area, 9 * kAreaRounding);
}

TEST(SectionArea, DoesNotChangeUnderRigidMotion) {
  const TriangleSoup muscle = Spindle(8, 40, 3);
  const Eigen::RowVector3d place(1, 2, 5), normal(0.1, 0.2, 1);
  const Eigen::Affine3d motion =
      Eigen::Translation3d(-120, 300, 45) *
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 3).normalized());
  const TriangleSoup moved = {Transformed(muscle.points, motion.matrix()),
                              muscle.triangles};
  const double area = AreaAt(muscle, place, normal);
  EXPECT_GT(area, 100);
  EXPECT_NEAR(AreaAt(moved,
                     (motion * place.transpose()).transpose(),
                     (motion.linear() * normal.transpose()).transpose()),
              area,
              kAreaRounding);
}

// As a muscle that bends around a bone.
TEST(SectionArea, IsOfThePieceAtThePlace) {
  TriangleSoup second = Cylinder();
  second.points.leftCols(2) *= 2;
  const TriangleSoup both = Together(Cylinder(), MovedBy(second, {50, 0, 0}));
  const Eigen::RowVector3d normal(0, 0, 1);
  EXPECT_NEAR(AreaAt(both, {3, 0, 9}, normal), kPolygon, kAreaRounding);
  EXPECT_NEAR(
      AreaAt(both, {60, 0, 9}, normal), 4 * kPolygon, 4 * kAreaRounding);
  // Outside of both, nearer to the first.
  EXPECT_NEAR(AreaAt(both, {15, 0, 9}, normal), kPolygon, kAreaRounding);
}

TEST(SectionArea, LeavesCavitiesOut) {
  TriangleSoup cavity = Cylinder();
  cavity.points *= 0.5;
  cavity.triangles.col(1).swap(cavity.triangles.col(2));
  const TriangleSoup hollow =
      Together(Cylinder(), MovedBy(cavity, {0, 0, kHeight / 4}));
  for (const double x : {0.0, 5.0, 20.0}) {
    EXPECT_NEAR(
        AreaAt(hollow, {x, 0, 20}, {0, 0, 1}), 0.75 * kPolygon, kAreaRounding);
  }
}

TEST(SectionArea, TakesVerticesOnThePlane) {
  const TriangleSoup box = LatticeBox(3, 4, 5);
  for (const double z : {1.0, 2.0, 2.5, 4.0}) {
    EXPECT_NEAR(AreaAt(box, {1, 1, z}, {0, 0, 1}), 12, kAreaRounding);
  }
}

TEST(LargestSectionArea, IsThatOfTheWidestPlace) {
  const TriangleSoup ball = Icosphere(10, 4);
  SectionPlanes planes;
  planes.places.resize(3, 3);
  planes.places << 0, 0, -6, 0, 0, 0, 0, 0, 8;
  planes.normals = Points::Zero(3, 3);
  planes.normals.col(2).setOnes();
  // The mesh lies inside of the ball, by 1 % of its area at most.
  EXPECT_NEAR(LargestSectionArea(ball.points, ball.triangles, planes),
              100 * M_PI,
              M_PI);
  EXPECT_EQ(LargestSectionArea(ball.points, ball.triangles, {}), 0);
}

}  // namespace
}  // namespace musclewarp
