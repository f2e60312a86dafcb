// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/crossing_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// The rounding of coordinates of some 10 mm.
constexpr double kRounding = 1e-12;

std::vector<CrossingPlace> PlacesOf(const std::vector<TriangleSoup>& muscles,
                                    const std::vector<TriangleSoup>& bones) {
  std::vector<std::unique_ptr<SearchableMesh>> meshes;
  std::vector<NamedMesh> named[2];
  for (const auto* soups : {&muscles, &bones}) {
    for (const TriangleSoup& soup : *soups) {
      meshes.push_back(std::make_unique<SearchableMesh>(soup));
      named[soups == &bones].push_back({"mesh", meshes.back().get()});
    }
  }
  return FindCrossingPlaces(named[0], named[1]);
}

// The number of points at which other than two pieces end.
int LooseEnds(const SegmentSoup& curve) {
  Eigen::VectorXi ends = Eigen::VectorXi::Zero(curve.points.rows());
  for (const int v : curve.segments.reshaped()) ++ends[v];
  return static_cast<int>((ends.array() != 2).count());
}

// A box of 2 x 2 mm with 4 vertices 0.3 mm deep in a large one.
TriangleSoup Peg(const Eigen::RowVector3d& at) {
  return MovedBy(Box(2, 2, 3), at + Eigen::RowVector3d(0, 0, 1.2));
}

TEST(FindCrossingPlaces, MeshesThatAreApartHaveNone) {
  EXPECT_TRUE(PlacesOf({Box(1, 1, 1), MovedBy(Box(1, 1, 1), {3, 0, 0})},
                       {MovedBy(Box(1, 1, 1), {0, 3, 0})})
                  .empty());
}

TEST(FindCrossingPlaces, TheCurveClosesAroundAPeg) {
  // The top of the large box is z = 5; the peg stands in it.
  const auto places = PlacesOf({Box(20, 20, 10)}, {Peg({0.3, -0.2, 5})});
  ASSERT_EQ(places.size(), 1u);
  const CrossingPlace& place = places[0];
  EXPECT_EQ(place.a, 0);
  EXPECT_EQ(place.b, 1);
  EXPECT_EQ(place.vertices_inside, 4);
  EXPECT_NEAR(place.depth_mm, 0.3, kRounding);
  EXPECT_NEAR(place.point[2], 4.7, kRounding);
  EXPECT_NEAR(CurveLength(place.curve), 8, kRounding);
  EXPECT_EQ(LooseEnds(place.curve), 0);
  EXPECT_LT((place.curve.points.col(2).array() - 5).abs().maxCoeff(),
            kRounding);
  // The sides of the peg; the top of the large box, whose diagonal it meets.
  EXPECT_EQ(place.triangles_of_b.size(), 8u);
  EXPECT_EQ(place.triangles_of_a.size(), 2u);
}

TEST(FindCrossingPlaces, PlacesWithNothingInCommonAreApart) {
  const TriangleSoup floor = LatticeBox(20, 20, 5);
  const auto places =
      PlacesOf({floor}, {Together(Peg({4.3, 4.2, 5}), Peg({14.3, 14.2, 5}))});
  ASSERT_EQ(places.size(), 2u);
  for (const CrossingPlace& place : places) {
    EXPECT_NEAR(CurveLength(place.curve), 8, kRounding);
    // Four corners of the peg, and four points of the lattice in it.
    EXPECT_EQ(place.vertices_inside, 8);
    EXPECT_EQ(LooseEnds(place.curve), 0);
  }
  EXPECT_GT((places[0].point - places[1].point).norm(), 10);
}

TEST(FindCrossingPlaces, WhatGoesThroughIsOnePlace) {
  // A pole through a plate enters and leaves; no vertex is inside the plate,
  // but the triangles of the pole are the same on both sides.
  const auto places =
      PlacesOf({MovedBy(Box(2, 2, 30), {0.1, 0.2, 0.3})}, {Box(20, 20, 4)});
  ASSERT_EQ(places.size(), 1u);
  EXPECT_NEAR(CurveLength(places[0].curve), 16, kRounding);
  EXPECT_EQ(places[0].vertices_inside, 0);
  EXPECT_EQ(places[0].depth_mm, 0);
}

TEST(FindCrossingPlaces, AMeshInsideAnotherHasNoCurve) {
  const auto places = PlacesOf({Box(2, 2, 2), Box(10, 10, 10)}, {});
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0].vertices_inside, 8);
  EXPECT_NEAR(places[0].depth_mm, 4, kRounding);
  EXPECT_TRUE(places[0].triangles_of_a.empty());
  EXPECT_EQ(places[0].curve.segments.rows(), 0);
}

TEST(FindCrossingPlaces, AMuscleMayCrossItself) {
  const TriangleSoup both = Together(Box(20, 20, 10), Peg({0.3, -0.2, 5}));
  const auto places = PlacesOf({both}, {});
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0].a, 0);
  EXPECT_EQ(places[0].b, 0);
  EXPECT_EQ(places[0].triangles_of_a.size(), 10u);
  EXPECT_NEAR(CurveLength(places[0].curve), 8, kRounding);
  EXPECT_EQ(LooseEnds(places[0].curve), 0);
  EXPECT_NEAR(places[0].point[2], 5, kRounding);
  // Nobody asks that of bones.
  EXPECT_TRUE(PlacesOf({}, {both}).empty());
}

TEST(FindCrossingPlaces, PairsAreThoseOfTheCertificate) {
  const TriangleSoup a = Icosphere(10, 3);
  const TriangleSoup b = MovedBy(Icosphere(8, 3), {9, 1, 2});
  const auto places = PlacesOf({a, b}, {});
  ASSERT_EQ(places.size(), 1u);
  const MeshIntersection found = IntersectMeshes(a, b);
  EXPECT_EQ(places[0].depth_mm, found.max_depth_mm);
  EXPECT_EQ(static_cast<size_t>(places[0].vertices_inside),
            found.a_inside_b.size() + found.b_inside_a.size());
  EXPECT_EQ(LooseEnds(places[0].curve), 0);
  // Two spheres cross in a circle around x, of radius 7.15.
  const double d = std::sqrt(86.0);
  const double x = (86 + 100 - 64) / (2 * d);
  const double circle = 2 * M_PI * std::sqrt(100 - x * x);
  // The meshes are inside the spheres, by 0.6 % of the radius at most.
  EXPECT_NEAR(CurveLength(places[0].curve), circle, 0.02 * circle);
}

}  // namespace
}  // namespace musclewarp
