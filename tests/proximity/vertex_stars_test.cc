// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/vertex_stars.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "musclewarp/cgal/triangle_intersection.h"
#include "proximity/crumpled_sphere.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

Corners CornersIn(const TriangleSoup& mesh, int f) {
  return CornersOf(mesh.points, mesh.triangles.row(f));
}

// The pairs of triangles around v that intersect beyond what they share.
int NumCrossingAround(const TriangleSoup& mesh, int v) {
  std::vector<int> around;
  for (int f = 0; f < mesh.triangles.rows(); ++f) {
    if ((mesh.triangles.row(f).array() == v).any()) around.push_back(f);
  }
  int crossing = 0;
  for (const int f : around) {
    for (const int g : around) {
      crossing += f < g && TrianglesIntersectBeyondCommon(CornersIn(mesh, f),
                                                          CornersIn(mesh, g));
    }
  }
  return crossing;
}

TEST(VertexRings, GoRoundEachVertexOfAClosedMesh) {
  const TriangleSoup sphere = Icosphere(10, 2);
  const VertexRings rings(sphere.triangles, sphere.points.rows());
  ASSERT_EQ(rings.num_vertices(), sphere.points.rows());
  for (int v = 0; v < rings.num_vertices(); ++v) {
    const int* ring = rings.begin(v);
    const auto count = rings.end(v) - ring;
    ASSERT_TRUE(count == 5 || count == 6) << v;
    for (int i = 0; i < count; ++i) {
      const Eigen::RowVector3i side(v, ring[i], ring[(i + 1) % count]);
      bool is_triangle = false;
      for (const auto& t : sphere.triangles.rowwise()) {
        for (int k = 0; k < 3; ++k) {
          is_triangle |= t[k] == side[0] && t[(k + 1) % 3] == side[1] &&
                         t[(k + 2) % 3] == side[2];
        }
      }
      EXPECT_TRUE(is_triangle);
    }
  }
}

TEST(VertexRings, AreEmptyWhereTrianglesAreNoRing) {
  TriangleSoup sphere = Icosphere(10, 1);
  // Without its last triangle, three vertices have open fans.
  const Eigen::RowVector3i open =
      sphere.triangles.row(sphere.triangles.rows() - 1);
  sphere.triangles.conservativeResize(sphere.triangles.rows() - 1, 3);
  const VertexRings rings(sphere.triangles, sphere.points.rows());
  for (int v = 0; v < rings.num_vertices(); ++v) {
    EXPECT_EQ(rings.begin(v) == rings.end(v), (open.array() == v).any()) << v;
  }
  // Two tetrahedra that share a vertex have two rings there.
  TriangleSoup two = Together(UnitTetrahedron(), UnitTetrahedron());
  two.triangles = (two.triangles.array() == 4).select(0, two.triangles);
  const VertexRings of_two(two.triangles, two.points.rows());
  EXPECT_EQ(of_two.begin(0), of_two.end(0));
  EXPECT_NE(of_two.begin(1), of_two.end(1));
}

TEST(ProperStars, AreThoseOfAConvexMesh) {
  const TriangleSoup sphere = Icosphere(10, 3);
  const VertexRings rings(sphere.triangles, sphere.points.rows());
  const std::vector<char> is_proper = ProperStars(rings, sphere.points);
  EXPECT_EQ(std::count(is_proper.begin(), is_proper.end(), 1),
            sphere.points.rows());
}

TEST(ProperStars, NeverHideACrossing) {
  for (const double by : {0.5, 1.5, 4.0}) {
    const TriangleSoup sphere = CrumpledSphere(by, 7);
    const VertexRings rings(sphere.triangles, sphere.points.rows());
    const std::vector<char> is_proper = ProperStars(rings, sphere.points);
    int crossing = 0;
    for (int v = 0; v < rings.num_vertices(); ++v) {
      const int here = NumCrossingAround(sphere, v);
      crossing += here;
      EXPECT_FALSE(is_proper[v] && here > 0) << by << " " << v;
    }
    EXPECT_EQ(crossing > 0, by > 1);
  }
}

// Any direction may be tried: a wrong one proves nothing, and never wrongly.
TEST(IsProperStar, IsNotFooledByAWrongDirection) {
  const TriangleSoup sphere = CrumpledSphere(3, 11);
  const VertexRings rings(sphere.triangles, sphere.points.rows());
  const Points directions = RandomPoints(40, 3);
  int proper = 0;
  for (int v = 0; v < rings.num_vertices(); ++v) {
    const int crossing = NumCrossingAround(sphere, v);
    for (const auto& up : directions.rowwise()) {
      if (!IsProperStar(rings, sphere.points, v, up)) continue;
      ++proper;
      EXPECT_EQ(crossing, 0) << v;
    }
  }
  EXPECT_GT(proper, 0);
}

// A star that goes round twice faces the viewer everywhere.
TEST(IsProperStar, IsNotOneThatGoesRoundTwice) {
  constexpr int kCount = 10;
  TriangleSoup star;
  star.points = Points::Zero(kCount + 1, 3);
  star.triangles.resize(kCount, 3);
  for (int i = 0; i < kCount; ++i) {
    const double angle = 4 * M_PI * i / kCount + 0.01;
    star.points.row(i + 1) << std::cos(angle), std::sin(angle), 0.1 * i;
    star.triangles.row(i) << 0, i + 1, (i + 1) % kCount + 1;
  }
  const VertexRings rings(star.triangles, star.points.rows());
  EXPECT_EQ(rings.end(0) - rings.begin(0), kCount);
  EXPECT_FALSE(IsProperStar(rings, star.points, 0, {0, 0, 1}));
  EXPECT_GT(NumCrossingAround(star, 0), 0);
}

}  // namespace
}  // namespace musclewarp
