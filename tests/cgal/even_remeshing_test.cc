// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/even_remeshing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Points are projected to the old surface, mm.
constexpr double kOnSurface = 1e-9;

// The lengths of the edges of a mesh, each once a triangle.
std::vector<double> EdgeLengths(const TriangleSoup& soup) {
  std::vector<double> lengths;
  for (const auto t : soup.triangles.rowwise()) {
    for (int k = 0; k < 3; ++k) {
      lengths.push_back(
          (soup.points.row(t[k]) - soup.points.row(t[(k + 1) % 3])).norm());
    }
  }
  return lengths;
}

}  // namespace

TEST(Remeshed, ASphereStaysOneWithEdgesOfTheLengthAskedFor) {
  const TriangleSoup ball = Icosphere(20, 4);  // edges of about 1.4 mm
  const TriangleBvh tree(ball.points, ball.triangles);
  const double volume = SignedVolume(ball.points, ball.triangles);
  for (const double length : {0.8, 3.0, 6.0}) {
    const TriangleSoup even = Remeshed(ball, length);
    EXPECT_TRUE(CountDefects(even).IsClean()) << length;
    const std::vector<double> lengths = EdgeLengths(even);
    // Botsch and Kobbelt split edges above 4/3 of the length and collapse
    // those below 4/5, and the spreading that follows moves few beyond.
    double mean = 0;
    for (const double l : lengths) mean += l / lengths.size();
    EXPECT_NEAR(mean, length, 0.15 * length);
    EXPECT_GT(*std::min_element(lengths.begin(), lengths.end()), length / 2);
    EXPECT_LT(*std::max_element(lengths.begin(), lengths.end()), 2 * length);
    for (const auto p : even.points.rowwise()) {
      EXPECT_LT(tree.ClosestPoint(p).distance, kOnSurface);
    }
    // Equilateral triangles between points of a sphere cut off 3/8 (length /
    // radius)^2 of its volume.
    EXPECT_NEAR(SignedVolume(even.points, even.triangles) / volume,
                1,
                0.4 * length * length / (20 * 20) + 1e-3)
        << length;
  }
}

TEST(Remeshed, LongTrianglesBecomeEven) {
  const TriangleSoup spindle = Spindle(8, 60, 3);
  const TriangleSoup even = Remeshed(spindle, 3);
  EXPECT_TRUE(CountDefects(even).IsClean());
  const std::vector<double> lengths = EdgeLengths(even);
  EXPECT_LT(*std::max_element(lengths.begin(), lengths.end()), 6);
}

TEST(Remeshed, LeavesTrianglesThatAreKept) {
  const TriangleSoup ball = Icosphere(20, 4);
  std::vector<bool> is_kept(ball.triangles.rows());
  for (Eigen::Index f = 0; f < ball.triangles.rows(); ++f) {
    is_kept[f] =
        CornersOf(ball.points, ball.triangles.row(f)).col(2).minCoeff() > 0;
  }
  const TriangleSoup mixed = Remeshed(ball, 6, is_kept);
  EXPECT_TRUE(CountDefects(mixed).IsClean());
  // Vertices on the border may go, those beyond the next ring stay.
  constexpr double kRing = 2;  // mm
  int above = 0;
  for (const auto p : mixed.points.rowwise()) above += p.z() > kRing;
  int expected = 0;
  for (const auto p : ball.points.rowwise()) expected += p.z() > kRing;
  EXPECT_EQ(above, expected);
  EXPECT_LT(mixed.points.rows() - above, expected / 4);
}

TEST(RemeshedDeathTest, NeedsAnEdgeLengthAboveZero) {
  EXPECT_DEATH(Remeshed(Icosphere(1, 1), 0), "edge_length");
}

}  // namespace musclewarp
