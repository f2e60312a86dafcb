// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/connectivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "support/meshes.h"

namespace musclewarp {
namespace {

Triangles ThreeAroundAnEdge() {
  Triangles triangles(3, 3);
  triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  return triangles;
}

// Two balls in one soup.
TriangleSoup TwoBalls() {
  TriangleSoup soup = Icosphere(10, 1);
  const Triangles one = soup.triangles;
  Points points(2 * soup.points.rows(), 3);
  points << soup.points, soup.points.rowwise() + Eigen::RowVector3d(30, 0, 0);
  soup.triangles.resize(2 * one.rows(), 3);
  soup.triangles << one, (one.array() + soup.points.rows()).matrix();
  soup.points = points;
  return soup;
}

TEST(HalfEdges, GoRoundTheirTriangle) {
  const Triangles triangles = UnitTetrahedron().triangles;
  for (int h = 0; h < triangles.size(); ++h) {
    EXPECT_EQ(NextHalfEdge(h) / 3, h / 3);
    EXPECT_EQ(NextHalfEdge(NextHalfEdge(NextHalfEdge(h))), h);
    EXPECT_EQ(OriginOf(triangles, NextHalfEdge(h)), TargetOf(triangles, h));
  }
}

TEST(UsesOfEdges, AreTwoPerEdgeOfAClosedManifold) {
  const TriangleSoup ball = Icosphere(10, 2);
  const EdgeUses edges(ball.triangles);
  // Euler: V - E + F = 2.
  EXPECT_EQ(static_cast<Eigen::Index>(edges.size()),
            ball.points.rows() + ball.triangles.rows() - 2);
  std::pair<int, int> last(-1, -1);
  for (const auto& uses : edges) {
    ASSERT_EQ(uses.size(), 2u);
    EXPECT_LT(uses[0], uses[1]);
    EXPECT_EQ(OriginOf(ball.triangles, uses[0]),
              TargetOf(ball.triangles, uses[1]));
    const std::pair<int, int> edge = std::minmax(
        {OriginOf(ball.triangles, uses[0]), TargetOf(ball.triangles, uses[0])});
    EXPECT_LT(last, edge);
    last = edge;
  }
}

TEST(UsesOfEdges, MayBeAnyNumber) {
  const EdgeUses edges(ThreeAroundAnEdge());
  ASSERT_EQ(edges.size(), 7u);
  EXPECT_EQ(std::vector<int>(edges[0].begin(), edges[0].end()),
            (std::vector<int>{0, 3, 6}));
  for (size_t i = 1; i < edges.size(); ++i) EXPECT_EQ(edges[i].size(), 1u);
}

TEST(UsesOfEdges, ATriangleWithARepeatedCornerHasNone) {
  Triangles triangles(1, 3);
  triangles << 4, 5, 4;
  EXPECT_TRUE(HasRepeatedCorner(triangles, 0));
  EXPECT_TRUE(EdgeUses(triangles).empty());
}

TEST(DisjointSets, AreRepresentedByTheirLowestMember) {
  DisjointSets sets(6);
  for (int i = 0; i < 6; ++i) EXPECT_EQ(sets.Find(i), i);
  sets.Join(5, 3);
  sets.Join(4, 2);
  sets.Join(3, 4);
  for (const int i : {2, 3, 4, 5}) EXPECT_EQ(sets.Find(i), 2);
  EXPECT_EQ(sets.Find(0), 0);
  EXPECT_EQ(sets.Find(1), 1);
}

TEST(DisjointSets, DoNotDependOnTheOrderOfJoins) {
  constexpr int kSize = 200;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> member(0, kSize - 1);
  std::vector<std::pair<int, int>> joins(kSize / 2);
  for (auto& [i, j] : joins) {
    i = member(random);
    j = member(random);
  }
  std::vector<int> first;
  for (int trial = 0; trial < 5; ++trial) {
    DisjointSets sets(kSize);
    for (const auto& [i, j] : joins) sets.Join(i, j);
    std::vector<int> roots(kSize);
    for (int i = 0; i < kSize; ++i) roots[i] = sets.Find(i);
    if (trial == 0) first = roots;
    EXPECT_EQ(roots, first);
    std::shuffle(joins.begin(), joins.end(), random);
    for (auto& [i, j] : joins) std::swap(i, j);
  }
}

TEST(ConnectedComponents, AreNumberedByTheirFirstTriangles) {
  const TriangleSoup balls = TwoBalls();
  // Triangles of the two balls in turn, the second ball first.
  const int half = static_cast<int>(balls.triangles.rows()) / 2;
  Triangles mixed(2 * half, 3);
  for (int f = 0; f < half; ++f) {
    mixed.row(2 * f) = balls.triangles.row(half + f);
    mixed.row(2 * f + 1) = balls.triangles.row(f);
  }
  const Components components = ConnectedComponents(mixed, EdgeUses(mixed), 2);
  EXPECT_EQ(components.count, 2);
  for (int f = 0; f < mixed.rows(); ++f) {
    EXPECT_EQ(components.label[f], f % 2);
  }
}

TEST(ConnectedComponents, MayEndAtCrowdedEdges) {
  const Triangles triangles = ThreeAroundAnEdge();
  const EdgeUses edges(triangles);
  EXPECT_EQ(ConnectedComponents(triangles, edges, 2).count, 3);
  EXPECT_EQ(ConnectedComponents(triangles, edges, 3).count, 1);
}

TEST(ConnectedComponents, ASharedPointDoesNotConnect) {
  Triangles triangles(2, 3);
  triangles << 0, 1, 2, 0, 3, 4;
  EXPECT_EQ(ConnectedComponents(triangles, EdgeUses(triangles), 2).count, 2);
}

TEST(DropUnreferencedPoints, KeepsTheOrderOfTheOthers) {
  TriangleSoup soup;
  soup.points.resize(6, 3);
  for (int v = 0; v < 6; ++v) soup.points.row(v).setConstant(v);
  soup.triangles.resize(1, 3);
  soup.triangles << 5, 1, 3;
  EXPECT_EQ(DropUnreferencedPoints(&soup), 3);
  ASSERT_EQ(soup.points.rows(), 3);
  EXPECT_EQ(soup.points.col(0), Eigen::Vector3d(1, 3, 5));
  EXPECT_EQ(soup.triangles.row(0), Eigen::RowVector3i(2, 0, 1));
  EXPECT_EQ(DropUnreferencedPoints(&soup), 0);
}

TEST(KeepTriangles, KeepsTheirOrder) {
  const Triangles all = UnitTetrahedron().triangles;
  Triangles kept = all;
  KeepTriangles({true, false, false, true}, &kept);
  ASSERT_EQ(kept.rows(), 2);
  EXPECT_EQ(kept.row(0), all.row(0));
  EXPECT_EQ(kept.row(1), all.row(3));
}

}  // namespace
}  // namespace musclewarp
