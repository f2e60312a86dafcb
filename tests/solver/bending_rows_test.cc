// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/bending_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// A quarter of a circle of radius 20 mm.
Points Arc(int segments) {
  Points arc(segments + 1, 3);
  for (int i = 0; i <= segments; ++i) {
    const double angle = M_PI / 2 * i / segments;
    arc.row(i) << 20 * std::cos(angle) - 10, 0, 20 * std::sin(angle) - 10;
  }
  return arc;
}

BendingRows Rows(const std::vector<Points>& fibres) {
  const TriangleSoup hull = Spindle(40, 60, 2);
  return MakeBendingRows(fibres, hull.points, hull.triangles, 7);
}

double Energy(const std::vector<Points>& fibres) {
  return (Rows(fibres).from_coarse * Spindle(40, 60, 2).points).squaredNorm();
}

}  // namespace

// The curvature of the arc is 1 / 20 mm; neither the number of points nor that
// of fibres counts.
TEST(BendingRows, SquaresAddUpToTheMeanOfTheSquaredCurvature) {
  const double expected = 7. * 7. / (20 * 20);
  EXPECT_NEAR(Energy({Arc(15)}), expected, 0.01 * expected);
  EXPECT_NEAR(Energy({Arc(60)}), expected, 0.001 * expected);
  EXPECT_NEAR(Energy({Arc(15), Arc(15), Arc(15)}), Energy({Arc(15)}), 1e-12);
}

TEST(BendingRows, AtRestTheTargetsAreMet) {
  const BendingRows rows = Rows({Arc(10), Arc(3)});
  ASSERT_EQ(rows.points.size(), 9u + 2u);
  const std::vector<Eigen::Matrix3d> rotations(rows.rest.rows(),
                                               Eigen::Matrix3d::Identity());
  const Points targets =
      BendingTargets(rows, rotations, Eigen::VectorXd::Ones(rows.rest.rows()));
  EXPECT_LT((rows.from_coarse * Spindle(40, 60, 2).points - targets)
                .cwiseAbs()
                .maxCoeff(),
            1e-11);
}

TEST(BendingRows, FibresThatCannotBendHaveNone) {
  EXPECT_TRUE(Rows({}).points.empty());
  EXPECT_EQ(Rows({}).from_coarse.cols(), Spindle(40, 60, 2).points.rows());
  EXPECT_TRUE(Rows({Arc(1), Points::Zero(5, 3)}).points.empty());
}

}  // namespace musclewarp
