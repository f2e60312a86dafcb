// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/sliver_removal.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Cuts the edge from corner 0 to corner 1 of a triangle, and so the triangle
// beyond, at `share` of its length; the new point lies `above` it.
void CutEdge(int f, double share, double above, TriangleSoup* soup) {
  const int a = soup->triangles(f, 0), b = soup->triangles(f, 1);
  const RowVector3d p =
      (1 - share) * soup->points.row(a) + share * soup->points.row(b);
  const int added = static_cast<int>(soup->points.rows());
  soup->points.conservativeResize(added + 1, 3);
  soup->points.row(added) = p * (1 + above / p.norm());
  const Eigen::Index count = soup->triangles.rows();
  for (Eigen::Index g = 0; g < count; ++g) {
    for (int k = 0; k < 3; ++k) {
      const int u = soup->triangles(g, k), v = soup->triangles(g, (k + 1) % 3);
      if (!(u == a && v == b) && !(u == b && v == a)) continue;
      const int w = soup->triangles(g, (k + 2) % 3);
      soup->triangles.conservativeResize(soup->triangles.rows() + 1, 3);
      soup->triangles.bottomRows<1>() << added, v, w;
      soup->triangles.row(g) << u, added, w;
      break;
    }
  }
}

double SmallestHeight(const TriangleSoup& soup) {
  double least = 1e9;
  for (Eigen::Index f = 0; f < soup.triangles.rows(); ++f) {
    const auto t = soup.triangles.row(f);
    const RowVector3d u = soup.points.row(t[1]) - soup.points.row(t[0]);
    const RowVector3d v = soup.points.row(t[2]) - soup.points.row(t[0]);
    const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
    least = std::min(least, u.cross(v).norm() / longest);
  }
  return least;
}

}  // namespace

TEST(RemoveSlivers, AMeshWithoutThemStaysAsItIs) {
  const TriangleSoup ball = Icosphere(20, 3);
  TriangleSoup soup = ball;
  const SliverRemovals removals = RemoveSlivers({}, &soup);
  EXPECT_EQ(removals.collapsed_edges + removals.flipped_edges, 0);
  EXPECT_EQ(removals.slivers_left, 0);
  EXPECT_EQ(soup.points, ball.points);
  EXPECT_EQ(soup.triangles, ball.triangles);
}

TEST(RemoveSlivers, NeedlesAndCapsGoAndTheSurfaceStays) {
  const TriangleSoup ball = Icosphere(20, 3);
  TriangleSoup soup = ball;
  CutEdge(10, 0.01, 0, &soup);     // two needles
  CutEdge(100, 0.99, 0, &soup);    // at the other end
  CutEdge(300, 0.5, 0.03, &soup);  // no sliver: an edge cut in half
  CutEdge(300, 0.04, 0.02, &soup);
  ASSERT_TRUE(CountDefects(soup).IsClean());
  const SliverLimits limits;
  ASSERT_LT(SmallestHeight(soup), limits.height);
  const double volume = SignedVolume(soup.points, soup.triangles);
  const SliverRemovals removals = RemoveSlivers(limits, &soup);
  EXPECT_EQ(removals.slivers_left, 0);
  EXPECT_GE(removals.collapsed_edges + removals.flipped_edges, 3);
  EXPECT_LE(removals.largest_deviation, limits.max_deviation);
  EXPECT_TRUE(CountDefects(soup).IsClean());
  // The mean edge is 3 mm: the limit of 0.25 mm holds.
  EXPECT_GE(SmallestHeight(soup), limits.height);
  // No more than the deviation over the triangles around four points.
  EXPECT_NEAR(SignedVolume(soup.points, soup.triangles), volume, 4 * 30 * 0.1);
  // What is not beside them keeps its place and number.
  EXPECT_EQ(soup.points.topRows(40), ball.points.topRows(40));
}

TEST(RemoveSlivers, DoesNotMakeSheetsCross) {
  // Two faces of 40 x 40 mm, 0.02 mm apart, one of them bulging by less than
  // that at a needle: no surface that leaves it out fits in between.
  TriangleSoup soup = Box(40, 40, 0.02);
  RemoveSlivers({}, &soup);
  EXPECT_EQ(SelfIntersections(soup).size(), 0u);
  EXPECT_TRUE(CountDefects(soup).IsClean());
}

TEST(RemoveSlivers, SaysWhatCannotGo) {
  // Flat from edge to edge: to take out its side faces would close it.
  TriangleSoup soup = Box(40, 40, 0.5);
  const SliverLimits limits;
  const TriangleSoup before = soup;
  const SliverRemovals removals = RemoveSlivers(limits, &soup);
  EXPECT_EQ(removals.slivers_left, 8);  // two on each of four sides
  EXPECT_EQ(soup.points, before.points);
}

TEST(RemoveSlivers, FineMeshesKeepTheirTriangles) {
  // Edges of 0.2 mm, all below the height that a coarse mesh should have.
  const TriangleSoup ball = Icosphere(1.2, 3);
  TriangleSoup soup = ball;
  RemoveSlivers({}, &soup);
  EXPECT_EQ(soup.triangles, ball.triangles);
}

}  // namespace musclewarp
