// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/mesh_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "certificate/exact_distance.h"
#include "certificate/surface_views.h"
#include "musclewarp/base/threads.h"
#include "musclewarp/mesh/box.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

constexpr double kSearchLimit = 2;  // mm

std::optional<MeshDistance> Distance(
    const TriangleSoup& a,
    const TriangleSoup& b,
    double limit = kSearchLimit,
    const std::vector<char>* exempt = nullptr) {
  const BoxedMesh mesh(ViewOf(a)), other(ViewOf(b));
  return DistanceSearch(mesh, limit).To(other, exempt);
}

// A ball of facets that is turned at random about its centre.
TriangleSoup RandomBall(double radius, int levels, std::mt19937* random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(
          uniform(*random), uniform(*random), uniform(*random), 1)
          .normalized();
  TriangleSoup ball = Icosphere(radius, levels);
  ball.points *= turn.toRotationMatrix();
  return ball;
}

// Pairs of triangles whose boxes are 4 mm apart or more are left out, which is
// right for meshes that are nearer: exact arithmetic takes its time.
CGAL::Exact_rational ExactSquaredMeshDistance(const TriangleSoup& a,
                                              const TriangleSoup& b) {
  constexpr double kNear = 4;
  CGAL::Exact_rational least = kNear * kNear;
  for (Eigen::Index f = 0; f < a.triangles.rows(); ++f) {
    const Corners triangle = CornersOf(a.points, a.triangles.row(f));
    const Box3 box = BoxOf(triangle, kNear);
    for (Eigen::Index g = 0; g < b.triangles.rows(); ++g) {
      const Corners other = CornersOf(b.points, b.triangles.row(g));
      if (!box.Overlaps(BoxOf(other))) continue;
      least = std::min(least, ExactSquaredDistance(triangle, other));
    }
  }
  return least;
}

void ExpectSame(const MeshDistance& a, const MeshDistance& b) {
  EXPECT_EQ(a.at_least, b.at_least);
  EXPECT_EQ(a.at_most, b.at_most);
  EXPECT_EQ(a.triangle_of_a, b.triangle_of_a);
  EXPECT_EQ(a.triangle_of_b, b.triangle_of_b);
  EXPECT_EQ(a.place, b.place);
}

TEST(DistanceSearch, KnowsTheGapBetweenBoxes) {
  const TriangleSoup box = Box(10, 10, 10);
  for (const RowVector3d& by : {RowVector3d(10.5, 0, 0),  // face to face
                                RowVector3d(10.5, 3, -4),
                                RowVector3d(0, -10.5, 9),
                                RowVector3d(10.25, 0, 10.25)}) {  // edges
    const auto distance = Distance(box, MovedBy(box, by));
    ASSERT_TRUE(distance);
    const double expected = (by.cwiseAbs().array() - 10).max(0).matrix().norm();
    EXPECT_LE(distance->at_least, expected);
    EXPECT_GE(distance->at_most, expected);
    EXPECT_LT(distance->at_most - distance->at_least, kTight);
  }
}

TEST(DistanceSearch, ContainsTheExactDistance) {
  std::mt19937 random(1);
  for (int i = 0; i < 3; ++i) {
    const TriangleSoup a = RandomBall(10, 0, &random);
    const TriangleSoup b =
        MovedBy(RandomBall(5, 1, &random), {13, 5, 5.0 + 0.2 * i});
    const auto distance = Distance(a, b, /*limit=*/4);
    ASSERT_TRUE(distance);
    const CGAL::Exact_rational squared = ExactSquaredMeshDistance(a, b);
    const CGAL::Exact_rational least = distance->at_least;
    const CGAL::Exact_rational most = distance->at_most;
    EXPECT_TRUE(least * least <= squared && squared <= most * most);
    EXPECT_LT(distance->at_most - distance->at_least, kTight);
    // The triangles that are named are that near.
    EXPECT_TRUE(
        ExactSquaredDistance(
            CornersOf(a.points, a.triangles.row(distance->triangle_of_a)),
            CornersOf(b.points, b.triangles.row(distance->triangle_of_b))) <=
        most * most);
  }
}

TEST(DistanceSearch, StaysProvedFarFromTheOrigin) {
  // The shift rounds the coordinates: the exact distance is that of the shifted
  // ones.
  std::mt19937 random(2);
  for (const double offset : {1e4, 1e7}) {
    const RowVector3d by = offset * RowVector3d(1, -0.3, 0.7);
    const TriangleSoup a = MovedBy(RandomBall(10, 0, &random), by);
    const TriangleSoup b =
        MovedBy(RandomBall(5, 1, &random), by + RowVector3d(13, 5, 5));
    const auto distance = Distance(a, b, /*limit=*/4);
    ASSERT_TRUE(distance);
    const CGAL::Exact_rational squared = ExactSquaredMeshDistance(a, b);
    const CGAL::Exact_rational least = distance->at_least;
    const CGAL::Exact_rational most = distance->at_most;
    EXPECT_TRUE(least * least <= squared && squared <= most * most);
    EXPECT_LT(distance->at_most - distance->at_least, kTight);
  }
}

TEST(DistanceSearch, DependsNeitherOnTheOrderNorOnThreads) {
  std::mt19937 random(3);
  const TriangleSoup a = RandomBall(10, 3, &random);
  const TriangleSoup b = MovedBy(RandomBall(10, 3, &random), {12, 12, 12});
  const auto distance = Distance(a, b);
  ASSERT_TRUE(distance);
  const auto swapped = Distance(b, a);
  EXPECT_EQ(swapped->at_least, distance->at_least);
  EXPECT_EQ(swapped->at_most, distance->at_most);
  EXPECT_EQ(swapped->place, distance->place);
  const int threads = NumThreads();
  for (const int count : {1, 2, 5}) {
    SetNumThreads(count);
    ExpectSame(*Distance(a, b), *distance);
  }
  SetNumThreads(threads);
  TriangleSoup reversed = b;
  reversed.triangles = b.triangles.colwise().reverse().eval();
  const auto renumbered = Distance(a, reversed);
  EXPECT_EQ(renumbered->at_least, distance->at_least);
  EXPECT_EQ(renumbered->at_most, distance->at_most);
}

TEST(DistanceSearch, OfEquallyNearTrianglesNamesTheLowest) {
  // The faces of two boxes, of two triangles each, are parallel.
  const TriangleSoup a = Box(10, 10, 10), b = MovedBy(a, {10.5, 0, 0});
  const auto distance = Distance(a, b);
  ASSERT_TRUE(distance);
  int first = 0;
  while (CornersOf(a.points, a.triangles.row(first)).col(0).minCoeff() < 5) {
    ++first;
  }
  EXPECT_EQ(distance->triangle_of_a, first);
}

TEST(DistanceSearch, BeyondTheLimitFindsNothing) {
  const TriangleSoup box = Box(10, 10, 10);
  EXPECT_TRUE(Distance(box, MovedBy(box, {11.5, 0, 0}), 1.5));
  EXPECT_FALSE(Distance(box, MovedBy(box, {11.5 + 1e-9, 0, 0}), 1.5));
  EXPECT_FALSE(Distance(box, MovedBy(box, {100, 0, 0}), 1.5));
  // Within the limit along every axis, but not over the corner.
  EXPECT_FALSE(Distance(box, MovedBy(box, {11, 11, 11}), 1.5));
}

TEST(DistanceSearch, MeshesThatTouchAreNotApart) {
  const TriangleSoup box = Box(10, 10, 10);
  for (const double x : {9.0, 10.0}) {
    const auto distance = Distance(box, MovedBy(box, {x, 1, 2}));
    ASSERT_TRUE(distance);
    EXPECT_EQ(distance->at_least, 0);
    EXPECT_EQ(distance->at_most, 0);
  }
}

TEST(DistanceSearch, LeavesOutExemptTriangles) {
  // Without the side that faces the other box, the other sides are nearest,
  // whose borders lie in it.
  const TriangleSoup a = LatticeBox(4, 4, 4);
  const TriangleSoup b = MovedBy(Box(1, 1, 1), {5, 2, 2});  // 0.5 mm from x = 4
  ASSERT_NEAR(Distance(a, b)->at_least, 0.5, kTight);
  std::vector<char> exempt(a.triangles.rows(), 0);
  for (Eigen::Index f = 0; f < a.triangles.rows(); ++f) {
    exempt[f] = CornersOf(a.points, a.triangles.row(f)).col(0).minCoeff() == 4;
  }
  const auto distance = Distance(a, b, kSearchLimit, &exempt);
  ASSERT_TRUE(distance);
  const double to_border = std::hypot(0.5, 1.5);
  EXPECT_LE(distance->at_least, to_border);
  EXPECT_GE(distance->at_most, to_border);
  EXPECT_FALSE(exempt[distance->triangle_of_a]);
  exempt.assign(exempt.size(), 1);
  EXPECT_FALSE(Distance(a, b, kSearchLimit, &exempt));
}

TEST(DistanceSearch, NothingIsFarFromEverything) {
  const TriangleSoup ball = Icosphere(3, 1), nothing;
  EXPECT_FALSE(Distance(nothing, ball));
  EXPECT_FALSE(Distance(ball, nothing));
}

}  // namespace
}  // namespace musclewarp
