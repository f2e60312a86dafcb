// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/soup_builder.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "mesh_files/format_checks.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

// Adds the points of a polygon in the plane.
void AddPoints(const std::vector<Eigen::Vector2d>& points,
               SoupBuilder* builder) {
  for (const auto& p : points) builder->AddPoint({p.x(), p.y(), 0});
}

std::vector<Eigen::Vector2d> Circle(int corners) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  return points;
}

TEST(SoupBuilder, KeepsTheOrderOfPointsAndFaces) {
  SoupBuilder builder("a");
  AddPoints(Circle(4), &builder);
  builder.AddPolygon({2, 3, 0});
  builder.AddPolygon({0, 1, 2});
  EXPECT_EQ(builder.num_points(), 4);
  EXPECT_EQ(builder.num_faces(), 2);
  const TriangleSoup soup = builder.Build();
  EXPECT_EQ(TextOf(soup.triangles), "2 3 0 0 1 2");
  EXPECT_EQ(soup.points.row(1), Eigen::RowVector3d(std::cos(M_PI / 2), 1, 0));
}

TEST(SoupBuilder, AConvexPolygonBecomesTheFanOfItsFirstCorner) {
  SoupBuilder builder("a");
  AddPoints(Circle(5), &builder);
  builder.AddPolygon({2, 3, 4, 0, 1});
  EXPECT_EQ(TextOf(builder.Build().triangles), "2 3 4 2 4 0 2 0 1");
}

TEST(SoupBuilder, AConcavePolygonIsSplitWithoutFolds) {
  // An arrow head: only the fans of corners 0 and 2 stay inside, and the face
  // starts with corner 1.
  SoupBuilder builder("a");
  AddPoints({{0, 0}, {4, -4}, {1, 0}, {4, 4}}, &builder);
  builder.AddPolygon({1, 2, 3, 0});
  const TriangleSoup soup = builder.Build();
  ASSERT_EQ(soup.triangles.rows(), 2);
  double area = 0;
  for (int f = 0; f < 2; ++f) {
    const Eigen::RowVector3d a = soup.points.row(soup.triangles(f, 0));
    const Eigen::RowVector3d b = soup.points.row(soup.triangles(f, 1));
    const Eigen::RowVector3d c = soup.points.row(soup.triangles(f, 2));
    const double twice = (b - a).cross(c - a).z();
    EXPECT_GT(twice, 0) << soup.triangles.row(f);
    area += twice / 2;
  }
  EXPECT_EQ(area, 4);
}

TEST(SoupBuilder, EverySecondTriangleOfAStripIsTurnedRound) {
  SoupBuilder builder("a");
  AddPoints(Circle(5), &builder);
  builder.AddStrip({0, 1, 2, 3, 4});
  EXPECT_EQ(TextOf(builder.Build().triangles), "0 1 2 2 1 3 2 3 4");
}

TEST(SoupBuilder, RepeatedCornersSteerAStrip) {
  SoupBuilder builder("a");
  AddPoints(Circle(6), &builder);
  builder.AddStrip({0, 1, 2, 2, 3, 4, 5});
  EXPECT_EQ(TextOf(builder.Build().triangles), "0 1 2 3 2 4 3 4 5");
}

TEST(SoupBuilder, CornersMayComeBeforeTheirPoints) {
  SoupBuilder builder("a");
  builder.AddPolygon({0, 1, 2});
  AddPoints(Circle(3), &builder);
  EXPECT_EQ(TextOf(builder.Build().triangles), "0 1 2");
}

TEST(SoupBuilder, AMissingCornerIsCountedAsTheFileCounts) {
  for (const int first : {0, 1}) {
    SoupBuilder builder("a.obj", first);
    AddPoints(Circle(3), &builder);
    builder.AddPolygon({0, 1, 2}, 4);
    builder.AddPolygon({0, 1, 3}, 5);
    const std::string one = std::to_string(1 + first);
    ExpectInputError(
        [&] { builder.Build(); },
        {"a.obj: line 5, face " + one,
         "vertex " + std::to_string(3 + first),
         "has 3 vertices, numbered from " + std::to_string(first)});
  }
}

TEST(SoupBuilder, ABinaryFileHasNoLines) {
  SoupBuilder builder("a.ply");
  ExpectInputError(
      [&] {
        builder.AddPolygon({0, 1});
      },
      {"a.ply: face 0: has 2 corners"});
}

TEST(SoupBuilder, CoordinatesMustBeFinite) {
  SoupBuilder builder("a.ply");
  builder.AddPoint({0, 0, 0}, 1);
  ExpectInputError(
      [&] {
        builder.AddPoint({1, NAN, 2.5}, 2);
      },
      {"a.ply: line 2, vertex 1", "(1, nan, 2.5)", "finite"});
  ExpectInputError([&] { builder.AddPoint({INFINITY, 0, 0}); }, {"inf"});
}

TEST(SoupBuilder, NoFacesAreRefused) {
  SoupBuilder builder("a.ply");
  AddPoints(Circle(3), &builder);
  ExpectInputError([&] { builder.Build(); }, {"no faces (3 vertices)"});
  builder.AddStrip({0, 1, 1});
  ExpectInputError([&] { builder.Build(); }, {"no faces"});
}

TEST(SoupBuilder, AMeshHasALargestSize) {
  MeshLimits limits;
  EXPECT_EQ(limits.vertices, 5000000);
  EXPECT_EQ(limits.faces, 10000000);
  limits = {3, 2};
  SoupBuilder builder("a.ply", 0, limits);
  AddPoints(Circle(3), &builder);
  ExpectInputError(
      [&] {
        builder.AddPoint({0, 0, 0});
      },
      {"a.ply", "more than 3 vertices", "simplify"});
  builder.AddPolygon({0, 1, 2});
  builder.AddPolygon({0, 2, 1});
  ExpectInputError(
      [&] {
        builder.AddPolygon({0, 1, 2});
      },
      {"a.ply", "more than 2 faces"});
  EXPECT_EQ(builder.Build().triangles.rows(), 2);
}

}  // namespace
}  // namespace musclewarp
