// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/mesh_intersection.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <random>

#include "musclewarp/geometry/triangle_intersection.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

TriangleSoup Shifted(TriangleSoup soup, const Eigen::RowVector3d& by) {
  soup.points.rowwise() += by;
  return soup;
}

using Pairs = std::vector<std::pair<int, int>>;

// Every triangle against every other.
Pairs BruteForce(const TriangleSoup& a, const TriangleSoup& b) {
  Pairs pairs;
  const auto corner = [](const TriangleSoup& soup, int f, int k) {
    return Eigen::RowVector3d(soup.points.row(soup.triangles(f, k)));
  };
  for (int f = 0; f < a.triangles.rows(); ++f) {
    for (int g = 0; g < b.triangles.rows(); ++g) {
      if (TrianglesIntersect(corner(a, f, 0),
                             corner(a, f, 1),
                             corner(a, f, 2),
                             corner(b, g, 0),
                             corner(b, g, 1),
                             corner(b, g, 2))) {
        pairs.emplace_back(f, g);
      }
    }
  }
  return pairs;
}

}  // namespace

TEST(MeshIntersection, OverlappingSpheresHaveAKnownDepth) {
  const TriangleSoup a = Icosphere(10, 3);
  const TriangleSoup b = Shifted(a, {16, 0, 0});
  const MeshIntersection found = IntersectMeshes(a, b);
  EXPECT_FALSE(found.triangle_pairs.empty());
  for (const int v : found.a_inside_b) {
    EXPECT_LT((a.points.row(v) - Eigen::RowVector3d(16, 0, 0)).norm(), 10);
  }
  EXPECT_GT(found.a_inside_b.size(), 10u);
  // The deepest point of a lies 4 mm inside b; facets are up to 0.15 mm flat.
  EXPECT_NEAR(found.max_depth_mm, 4, 0.2);
  EXPECT_EQ(found.max_depth_mm, std::max(found.a_depth_mm, found.b_depth_mm));
}

TEST(MeshIntersection, FindsWhatBruteForceFinds) {
  std::mt19937 engine(2);
  const TriangleSoup a = Spindle(5, 12, 2);
  for (int i = 0; i < 10; ++i) {
    Eigen::RowVector3d by;
    for (int k = 0; k < 3; ++k) by[k] = static_cast<int>(engine() % 16) - 8;
    const TriangleSoup b = Shifted(Spindle(6, 7, 2), by);
    EXPECT_EQ(IntersectMeshes(a, b).triangle_pairs, BruteForce(a, b));
  }
}

TEST(MeshIntersection, SeesContainmentWithoutCrossing) {
  const TriangleSoup outer = Icosphere(10, 2);
  const TriangleSoup inner = Icosphere(3, 2);
  const MeshIntersection found = IntersectMeshes(outer, inner);
  EXPECT_TRUE(found.triangle_pairs.empty());
  EXPECT_TRUE(found.a_inside_b.empty());
  EXPECT_EQ(found.b_inside_a.size(), static_cast<size_t>(inner.points.rows()));
  EXPECT_FALSE(found.IsEmpty());
}

TEST(MeshIntersection, SeesEdgesThatCrossWithoutVerticesInside) {
  // Two long boxes in a cross.
  const MeshIntersection found =
      IntersectMeshes(Box(20, 2, 2), Box(2, 20, 2.5));
  EXPECT_FALSE(found.triangle_pairs.empty());
  EXPECT_TRUE(found.a_inside_b.empty());
  EXPECT_TRUE(found.b_inside_a.empty());
  EXPECT_FALSE(found.IsEmpty());
}

TEST(MeshIntersection, IsEmptyApart) {
  EXPECT_TRUE(
      IntersectMeshes(Box(2, 2, 2), Shifted(Box(2, 2, 2), {2.001, 0, 0}))
          .IsEmpty());
}

TEST(MeshIntersection, AnswersForOpenMeshes) {
  TriangleSoup open = Icosphere(10, 3);
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  const TriangleSoup inner = Shifted(Icosphere(1, 1), {-4, 0, 0});
  EXPECT_EQ(IntersectMeshes(open, inner).b_inside_a.size(),
            static_cast<size_t>(inner.points.rows()));
}

TEST(MeshIntersection, DoesNotDependOnTheNumberOfThreads) {
  const TriangleSoup a = Icosphere(10, 3);
  const TriangleSoup b = Shifted(Spindle(8, 20, 3), {5, 3, 1});
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const MeshIntersection one = IntersectMeshes(a, b);
  omp_set_num_threads(3);
  const MeshIntersection three = IntersectMeshes(a, b);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.triangle_pairs, three.triangle_pairs);
  EXPECT_EQ(one.a_inside_b, three.a_inside_b);
  EXPECT_EQ(one.b_inside_a, three.b_inside_a);
  EXPECT_EQ(one.max_depth_mm, three.max_depth_mm);
}

TEST(SelfIntersections, NoneInACleanMesh) {
  EXPECT_TRUE(SelfIntersections(Icosphere(10, 3)).empty());
  EXPECT_TRUE(SelfIntersections(Box(1, 2, 3)).empty());
}

TEST(SelfIntersections, FindsAVertexPushedThroughTheOtherSide) {
  TriangleSoup sphere = Icosphere(10, 2);
  sphere.points.row(0) *= -1.5;
  EXPECT_FALSE(SelfIntersections(sphere).empty());
}

TEST(SelfIntersections, FindsFoldsAndDoubles) {
  // Two triangles of one edge, folded flat onto each other.
  TriangleSoup fold;
  fold.points.resize(4, 3);
  fold.points << 0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 0;
  fold.triangles.resize(2, 3);
  fold.triangles << 0, 1, 2, 1, 0, 3;
  EXPECT_EQ(SelfIntersections(fold), (Pairs{{0, 1}}));
  fold.points.row(3) << 1, -1, 0;
  EXPECT_TRUE(SelfIntersections(fold).empty());
  fold.triangles.row(1) << 2, 0, 1;
  EXPECT_EQ(SelfIntersections(fold), (Pairs{{0, 1}}));
}

}  // namespace musclewarp
