// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/proximity/triangle_distance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "musclewarp/cgal/triangle_intersection.h"
#include "proximity/random_meshes.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using PairList = std::vector<std::pair<int, int>>;

// Every triangle against every other.
PairList BruteForce(const TriangleSoup& a, const TriangleSoup& b) {
  PairList pairs;
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

PairList PairsByBruteForce(const SearchableMesh& a, const SearchableMesh& b) {
  PairList pairs;
  for (int f = 0; f < a.triangles().rows(); ++f) {
    for (int g = 0; g < b.triangles().rows(); ++g) {
      if (TrianglesIntersect(a.bvh().corners(f), b.bvh().corners(g))) {
        pairs.emplace_back(f, g);
      }
    }
  }
  return pairs;
}

std::vector<int> InsideByBruteForce(const SearchableMesh& a,
                                    const SearchableMesh& b) {
  std::set<int> inside;
  for (Eigen::Index i = 0; i < a.triangles().size(); ++i) {
    const int v = a.triangles().data()[i];
    if (b.winding().IsInside(a.points().row(v))) inside.insert(v);
  }
  return {inside.begin(), inside.end()};
}

double DepthByBruteForce(const SearchableMesh& a, const SearchableMesh& b) {
  double depth = 0;
  for (const int v : InsideByBruteForce(a, b)) {
    const RowVector3d p = a.points().row(v);
    double least = INFINITY;
    for (int g = 0; g < b.triangles().rows(); ++g) {
      least = std::min(
          least, (ClosestPointOfTriangle(p, b.bvh().corners(g)) - p).norm());
    }
    depth = std::max(depth, least);
  }
  return depth;
}

void ExpectBruteForce(const TriangleSoup& soup_a, const TriangleSoup& soup_b) {
  const SearchableMesh a(soup_a);
  const SearchableMesh b(soup_b);
  const MeshIntersection result = IntersectMeshes(a, b);
  EXPECT_EQ(result.triangle_pairs, PairsByBruteForce(a, b));
  EXPECT_EQ(result.a_inside_b, InsideByBruteForce(a, b));
  EXPECT_EQ(result.b_inside_a, InsideByBruteForce(b, a));
  EXPECT_EQ(result.a_depth_mm, DepthByBruteForce(a, b));
  EXPECT_EQ(result.b_depth_mm, DepthByBruteForce(b, a));
  EXPECT_EQ(result.max_depth_mm,
            std::max(result.a_depth_mm, result.b_depth_mm));
}

TriangleSoup WithHole(TriangleSoup soup, int triangles) {
  soup.triangles =
      soup.triangles.bottomRows(soup.triangles.rows() - triangles).eval();
  return soup;
}

}  // namespace

TEST(MeshIntersection, OverlappingSpheresHaveAKnownDepth) {
  const TriangleSoup a = Icosphere(10, 3);
  const TriangleSoup b = MovedBy(a, {16, 0, 0});
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
    const TriangleSoup b = MovedBy(Spindle(6, 7, 2), by);
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
      IntersectMeshes(Box(2, 2, 2), MovedBy(Box(2, 2, 2), {2.001, 0, 0}))
          .IsEmpty());
}

TEST(MeshIntersection, AnswersForOpenMeshes) {
  TriangleSoup open = Icosphere(10, 3);
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  const TriangleSoup inner = MovedBy(Icosphere(1, 1), {-4, 0, 0});
  EXPECT_EQ(IntersectMeshes(open, inner).b_inside_a.size(),
            static_cast<size_t>(inner.points.rows()));
}

TEST(MeshIntersection, DoesNotDependOnTheNumberOfThreads) {
  const TriangleSoup a = Icosphere(10, 3);
  const TriangleSoup b = MovedBy(Spindle(8, 20, 3), {5, 3, 1});
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
  EXPECT_EQ(SelfIntersections(fold), (PairList{{0, 1}}));
  fold.points.row(3) << 1, -1, 0;
  EXPECT_TRUE(SelfIntersections(fold).empty());
  fold.triangles.row(1) << 2, 0, 1;
  EXPECT_EQ(SelfIntersections(fold), (PairList{{0, 1}}));
}

TEST(MeshIntersection, AgreesWithBruteForce) {
  std::mt19937 random(1);
  for (int i = 0; i < 10; ++i) {
    ExpectBruteForce(Icosphere(10, 2),
                     MovedBy(Spindle(4, 12, 2), RandomPoint(10, &random)));
  }
}

TEST(MeshIntersection, AgreesWithBruteForceOnOpenMeshes) {
  std::mt19937 random(2);
  for (int i = 0; i < 6; ++i) {
    ExpectBruteForce(
        WithHole(Icosphere(10, 2), 20 * i),
        MovedBy(WithHole(Icosphere(8, 2), 30), RandomPoint(8, &random)));
  }
}

TEST(MeshIntersection, AgreesWithBruteForceInSpecialPosition) {
  for (int x = 0; x <= 4; ++x) {
    for (int y = 0; y <= 4; ++y) {
      ExpectBruteForce(Box(2, 2, 2),
                       MovedBy(Box(2, 2, 2), RowVector3d(x, y, 1) / 2));
      ExpectBruteForce(Box(2, 2, 2),
                       MovedBy(Box(2, 4, 1), RowVector3d(x, y, 0) / 2));
    }
  }
}

TEST(MeshIntersection, BoxesFaceToFaceTouchButAreNotInside) {
  const MeshIntersection result = IntersectMeshes(
      Box(2, 2, 2), MovedBy(Box(1, 1, 2), RowVector3d(0, 0, 2)));
  EXPECT_FALSE(result.triangle_pairs.empty());
  EXPECT_THAT(result.a_inside_b, IsEmpty());
  EXPECT_THAT(result.b_inside_a, IsEmpty());
  EXPECT_EQ(result.max_depth_mm, 0);
}

TEST(MeshIntersection, AMeshWithItselfTouchesOnly) {
  const TriangleSoup sphere = Icosphere(10, 2);
  const MeshIntersection result = IntersectMeshes(sphere, sphere);
  EXPECT_GE(result.triangle_pairs.size(), sphere.triangles.rows());
  EXPECT_THAT(result.a_inside_b, IsEmpty());
  EXPECT_THAT(result.b_inside_a, IsEmpty());
}

TEST(MeshIntersection, PointsInNoTriangleDoNotCount) {
  TriangleSoup soup = MovedBy(Icosphere(1, 1), RowVector3d(50, 0, 0));
  soup.points.conservativeResize(soup.points.rows() + 1, 3);
  soup.points.bottomRows<1>().setZero();
  EXPECT_TRUE(IntersectMeshes(soup, Box(20, 20, 20)).IsEmpty());
}

TEST(MeshIntersection, NoTriangles) {
  const TriangleSoup empty = {Points(0, 3), Triangles(0, 3)};
  EXPECT_TRUE(IntersectMeshes(empty, Box(1, 1, 1)).IsEmpty());
  EXPECT_TRUE(IntersectMeshes(Box(1, 1, 1), empty).IsEmpty());
}

TEST(MeshIntersection, RefittedMeshesAreLikeNewOnes) {
  const TriangleSoup sphere = Icosphere(10, 2);
  const TriangleSoup spindle = Spindle(4, 12, 2);
  SearchableMesh moving(MovedBy(spindle, RowVector3d(30, 0, 0)));
  moving.Refit(MovedBy(spindle, RowVector3d(7, 1, 2)).points);
  const MeshIntersection refitted =
      IntersectMeshes(SearchableMesh(sphere), moving);
  const MeshIntersection built =
      IntersectMeshes(sphere, MovedBy(spindle, RowVector3d(7, 1, 2)));
  EXPECT_FALSE(built.IsEmpty());
  EXPECT_EQ(refitted.triangle_pairs, built.triangle_pairs);
  EXPECT_EQ(refitted.a_inside_b, built.a_inside_b);
  EXPECT_EQ(refitted.b_inside_a, built.b_inside_a);
  EXPECT_EQ(refitted.max_depth_mm, built.max_depth_mm);
}

TEST(SelfIntersections, TwoBodiesInOneMeshAreTheirPairs) {
  const TriangleSoup a = Icosphere(10, 2);
  const TriangleSoup b = MovedBy(a, RowVector3d(3, 4, 5));
  PairList expected = IntersectMeshes(a, b).triangle_pairs;
  for (auto& pair : expected) {
    pair.second += static_cast<int>(a.triangles.rows());
  }
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(SelfIntersections(Together(a, b)), expected);
}

TEST(SelfIntersections, AgreesWithBruteForce) {
  std::mt19937 random(3);
  TriangleSoup soup = Icosphere(1, 2);
  for (Eigen::Index i = 0; i < soup.points.rows(); ++i) {
    soup.points.row(i) += RandomPoint(0.2, &random);
  }
  const TriangleBvh bvh(soup.points, soup.triangles);
  PairList expected;
  for (int f = 0; f < bvh.num_triangles(); ++f) {
    for (int g = f + 1; g < bvh.num_triangles(); ++g) {
      if (TrianglesIntersectBeyondCommon(bvh.corners(f), bvh.corners(g))) {
        expected.emplace_back(f, g);
      }
    }
  }
  EXPECT_GT(expected.size(), 10);
  EXPECT_EQ(SelfIntersections(soup), expected);
}

TEST(SelfIntersections, PointsAreCommonByCoordinates) {
  TriangleSoup soup;
  const TriangleSoup box = Box(1, 1, 1);
  soup.points.resize(36, 3);
  soup.triangles.resize(12, 3);
  for (int i = 0; i < 36; ++i) {
    soup.points.row(i) = box.points.row(box.triangles.data()[i]);
    soup.triangles.data()[i] = i;
  }
  EXPECT_THAT(SelfIntersections(soup), IsEmpty());
}

TEST(SelfIntersections, DuplicateTriangles) {
  TriangleSoup soup = UnitTetrahedron();
  soup.triangles.conservativeResize(5, 3);
  soup.triangles.row(4) = soup.triangles.row(1).reverse().eval();
  EXPECT_THAT(SelfIntersections(soup), ElementsAre(std::make_pair(1, 4)));
}

}  // namespace musclewarp
