// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "mesh_repair/repaired.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_repair/repair.h"

// Bodies that touch each other or themselves, made of unit cubes: segmented
// voxels meet along edges and in corners in every possible way.
namespace musclewarp {
namespace {

using Cell = std::array<int, 3>;
using Cells = std::set<Cell>;

// The outward boundary of a set of unit cubes, two triangles a face.
TriangleSoup Surface(const Cells& cells) {
  std::map<Cell, int> corner_index;
  std::vector<Eigen::RowVector3i> triangles;
  const auto corner = [&](const Cell& place) {
    return corner_index.try_emplace(place, corner_index.size()).first->second;
  };
  for (const Cell& cell : cells) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell beyond = cell;
        beyond[axis] += side == 1 ? 1 : -1;
        if (cells.count(beyond)) continue;
        std::array<int, 4> quad;
        for (int i = 0; i < 4; ++i) {
          Cell place = cell;
          place[axis] += side;
          place[(axis + 1) % 3] += i == 1 || i == 2;
          place[(axis + 2) % 3] += i >= 2;
          quad[i] = corner(place);
        }
        if (side == 0) std::swap(quad[1], quad[3]);
        triangles.emplace_back(quad[0], quad[1], quad[2]);
        triangles.emplace_back(quad[0], quad[2], quad[3]);
      }
    }
  }
  TriangleSoup soup;
  soup.points.resize(corner_index.size(), 3);
  for (const auto& [place, index] : corner_index) {
    soup.points.row(index) << place[0], place[1], place[2];
  }
  soup.triangles.resize(triangles.size(), 3);
  for (size_t f = 0; f < triangles.size(); ++f) {
    soup.triangles.row(f) = triangles[f];
  }
  return soup;
}

// Points that are pulled apart move by a thousandth of an edge of at most
// sqrt(2); around each lie at most a dozen triangles of area 1/2.
constexpr double kPulled = 1e-3 * 12 * 0.5;

TEST(RepairTouching, OfTwoBodiesAtAVertexTheLargerStays) {
  const TriangleSoup soup = Surface({{0, 0, 0}, {0, 0, 1}, {1, 1, 2}});
  ASSERT_EQ(CountDefects(soup).non_manifold_vertices, 1);
  RepairReport report;
  // Whole numbers: the volume is exact up to the division by six.
  EXPECT_NEAR(Volume(Repaired(soup, &report)), 2, 1e-12);
  EXPECT_EQ(report.separated_vertices, 1);
  EXPECT_EQ(report.dropped_pieces.size(), 1);
}

TEST(RepairTouching, OfTwoBodiesAlongAnEdgeTheLargerStays) {
  const TriangleSoup soup = Surface({{0, 0, 0}, {-1, 0, 0}, {1, 1, 0}});
  ASSERT_EQ(CountDefects(soup).non_manifold_edges, 1);
  RepairReport report;
  EXPECT_NEAR(Volume(Repaired(soup, &report)), 2, 1e-12);
  EXPECT_EQ(report.separation.edges, 1);
  EXPECT_EQ(report.dropped_pieces.size(), 1);
}

TEST(RepairTouching, ABodyInsideOutBesideAnotherDoesNotSpoilThePairing) {
  TriangleSoup soup = Surface({{0, 0, 0}, {-1, 0, 0}, {1, 1, 0}});
  for (int f = 0; f < soup.triangles.rows(); ++f) {
    double highest = 0;
    for (int c = 0; c < 3; ++c) {
      highest = std::max(highest, soup.points(soup.triangles(f, c), 1));
    }
    if (highest > 1) soup.triangles.row(f).reverseInPlace();
  }
  RepairReport report;
  EXPECT_NEAR(Volume(Repaired(soup, &report)), 2, 1e-12);
}

TEST(RepairTouching, ARingThatMeetsItselfAlongAnEdgeOpens) {
  // Cubes in a row that comes back to touch its start along an edge only.
  const Cells ring = {{0, 0, 0},
                      {1, 0, 0},
                      {2, 0, 0},
                      {2, 1, 0},
                      {2, 2, 0},
                      {1, 2, 0},
                      {0, 2, 0},
                      {-1, 2, 0},
                      {-1, 1, 0}};
  const TriangleSoup soup = Surface(ring);
  ASSERT_EQ(CountDefects(soup).non_manifold_edges, 1);
  RepairReport report;
  const TriangleSoup repaired = Repaired(soup, &report);
  EXPECT_GT(report.pulls.points, 0);
  EXPECT_NEAR(Volume(repaired), ring.size(), 2 * kPulled);
  // V - E + F = 2: a bent rod, no ring any more.
  EXPECT_EQ(repaired.points.rows() - repaired.triangles.rows() / 2, 2);
}

TEST(RepairTouching, AnEdgeInOneFanAtBothEndsIsSplit) {
  // Two cubes that touch along an edge, between two full layers: the surface
  // runs around both ends of the edge in one fan, so that copies of the ends
  // cannot tell the two sheets apart.
  Cells cells;
  for (int x = -1; x <= 2; ++x) {
    for (int y = -1; y <= 2; ++y) {
      for (const int z : {0, 2}) cells.insert({x, y, z});
      const bool is_hollow = (x == 0 && y == 1) || (x == 1 && y == 0);
      if (!is_hollow) cells.insert({x, y, 1});
    }
  }
  const TriangleSoup soup = Surface(cells);
  ASSERT_EQ(CountDefects(soup).non_manifold_edges, 1);
  RepairReport report;
  const TriangleSoup repaired = Repaired(soup, &report);
  // The cavities are pieces of their own and filled.
  EXPECT_NEAR(Volume(repaired), 48, 1e-12);
}

TEST(RepairTouching, AnyVoxelsGiveAManifold) {
  std::mt19937 random(11);
  std::bernoulli_distribution is_full(0.6);
  int edges = 0;
  int pulls = 0;
  for (int trial = 0; trial < 30; ++trial) {
    Cells cells;
    for (int i = 0; i < 216; ++i) {
      if (is_full(random)) cells.insert({i % 6, i / 6 % 6, i / 36});
    }
    RepairReport report;
    const TriangleSoup once = Repaired(Surface(cells), &report);
    edges += report.separation.edges;
    pulls += report.pulls.points;
    EXPECT_GT(Volume(once), 0);
    const TriangleSoup twice = Repaired(once, &report);
    EXPECT_EQ(once.triangles, twice.triangles);
    EXPECT_FALSE(report.AnythingDone());
  }
  EXPECT_GT(edges, 100);  // The trials do exercise what they are for.
  EXPECT_GT(pulls, 100);
}

TEST(RepairTouching, AnyHeapOfTrianglesIsRepairedOrRefused) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> vertex(0, 15);
  std::uniform_real_distribution<double> coordinate(-5, 5);
  int refused = 0;
  for (int trial = 0; trial < 200; ++trial) {
    TriangleSoup soup;
    soup.points.resize(16, 3);
    for (int i = 0; i < soup.points.size(); ++i) {
      soup.points.data()[i] = coordinate(random);
    }
    soup.triangles.resize(8 + trial / 4, 3);
    for (int i = 0; i < soup.triangles.size(); ++i) {
      soup.triangles.data()[i] = vertex(random);
    }
    RepairReport report;
    try {
      Repaired(soup, &report);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 200);
}

}  // namespace
}  // namespace musclewarp
