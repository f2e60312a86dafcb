// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/polygonize.h"

#include <gtest/gtest.h>

#include <cmath>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp::phantom {
namespace {

constexpr double kPi = 3.14159265358979323846;

Eigen::AlignedBox3d Cube(double half) {
  return {Eigen::Vector3d::Constant(-half), Eigen::Vector3d::Constant(half)};
}

TEST(PolygonizeField, MakesAClosedBallOfTheRightSize) {
  PolygonizeOptions options;
  options.cell = 2;
  const TriangleSoup ball =
      PolygonizeField(Sphere({0.3, -0.2, 0.1}, 12), Cube(20), options);
  EXPECT_TRUE(CountDefects(ball).IsClean());
  for (Eigen::Index i = 0; i < ball.points.rows(); ++i) {
    const Eigen::Vector3d p = ball.points.row(i).transpose();
    // Newton's method ends at rounding to 2^-10 along three axes.
    EXPECT_NEAR((p - Eigen::Vector3d(0.3, -0.2, 0.1)).norm(), 12, 1e-3);
  }
  // Facets of 2 mm cut a share of about (2 / 12)^2 / 4 off a ball.
  const double volume = 4 * kPi / 3 * 12 * 12 * 12;
  EXPECT_NEAR(
      SignedVolume(ball.points, ball.triangles) / volume, 1 - 0.004, 0.006);
}

TEST(PolygonizeField, KeepsTheHoleOfARing) {
  const Field ring = [](const Eigen::Vector3d& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 15, p.z()) - 5;
  };
  const TriangleSoup soup = PolygonizeField(ring, Cube(25), {});
  EXPECT_TRUE(CountDefects(soup).IsClean());
  // V - E + F, with 3 F = 2 E.
  EXPECT_EQ(soup.points.rows() - soup.triangles.rows() / 2, 0);
}

TEST(PolygonizeField, PointsAreMultiplesOfAPowerOfTwo) {
  const TriangleSoup ball = PolygonizeField(Sphere({0, 0, 0}, 9), Cube(15), {});
  const Points scaled = 1024 * ball.points;
  EXPECT_EQ(scaled, Points(scaled.array().round()));
}

TEST(PolygonizeField, EdgesAreOfTheSizeOfTheCells) {
  PolygonizeOptions options;
  options.cell = 2.5;
  const TriangleSoup ball =
      PolygonizeField(Sphere({0, 0, 0}, 15), Cube(20), options);
  for (Eigen::Index f = 0; f < ball.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const double length = (ball.points.row(ball.triangles(f, k)) -
                             ball.points.row(ball.triangles(f, (k + 1) % 3)))
                                .norm();
      // Neighbouring cells: from half an edge to the diagonal of a face.
      EXPECT_GT(length, 0.4 * options.cell);
      EXPECT_LT(length, 1.7 * options.cell);
    }
  }
}

// Solids thinner than the cells, or touching diagonally, are where the plain
// net would meet itself along edges.
TEST(PolygonizeField, StaysAManifoldWhereTheSolidIsThin) {
  for (int turn = 0; turn < 8; ++turn) {
    const Eigen::Vector3d normal(
        std::cos(0.4 * turn), std::sin(0.4 * turn), 0.2 + 0.1 * turn);
    const Field plate = Intersection(
        Intersection(HalfSpace(normal, 1.6), HalfSpace(-normal, 1.6), 0),
        Sphere({0, 0, 0}, 14),
        2);
    const MeshDefects defects =
        CountDefects(PolygonizeField(plate, Cube(20), {}));
    EXPECT_EQ(defects.non_manifold_edges, 0) << "turn " << turn;
    EXPECT_EQ(defects.non_manifold_vertices, 0) << "turn " << turn;
    EXPECT_EQ(defects.border_edges, 0) << "turn " << turn;
    EXPECT_EQ(defects.misoriented_edges, 0) << "turn " << turn;
  }
}

}  // namespace
}  // namespace musclewarp::phantom
