// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/cotangent_laplacian.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace musclewarp {

namespace {

// Sums of a few weights of size 1.
constexpr double kWeightRounding = 1e-13;

}  // namespace

TEST(CotangentLaplacian, HasTheWeightsOfTheAnglesAcross) {
  // Every edge of a regular tetrahedron sees two angles of 60 degrees.
  TriangleSoup soup = UnitTetrahedron();
  soup.points << 1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1;
  CotangentLaplacianOptions options;
  options.normalize_rows = false;
  const Eigen::MatrixXd l =
      CotangentLaplacian(soup.points, soup.triangles, options);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      EXPECT_NEAR(
          l(i, j), (i == j ? -3 : 1) * 2 / std::sqrt(3.0), kWeightRounding);
    }
  }
}

TEST(CotangentLaplacian, ConstantsAreInTheNullSpace) {
  const TriangleSoup spindle = Spindle(3, 20, 2);
  const SparseMatrix l =
      CotangentLaplacian(spindle.points, spindle.triangles, {});
  EXPECT_LT((l * Eigen::VectorXd::Ones(l.cols())).cwiseAbs().maxCoeff(),
            kWeightRounding);
}

TEST(CotangentLaplacian, PointsInwardOnAConvexMesh) {
  const TriangleSoup sphere = Icosphere(10, 2);
  const Points delta =
      CotangentLaplacian(sphere.points, sphere.triangles, {}) * sphere.points;
  for (Eigen::Index i = 0; i < delta.rows(); ++i) {
    const double cosine =
        delta.row(i).normalized().dot(-sphere.points.row(i).normalized());
    EXPECT_GT(cosine, 0.99);
  }
}

TEST(CotangentLaplacian, BoundsTheWeightsOfSlivers) {
  // A vertex on the edge across: cotangents of 0 and pi.
  TriangleSoup sphere = Icosphere(10, 1);
  sphere.points.row(sphere.triangles(0, 2)) =
      (sphere.points.row(sphere.triangles(0, 0)) +
       sphere.points.row(sphere.triangles(0, 1))) /
      2;
  CotangentLaplacianOptions options;
  options.normalize_rows = false;
  const SparseMatrix l =
      CotangentLaplacian(sphere.points, sphere.triangles, options);
  const double bound = 2 / std::tan(options.min_angle);
  for (int i = 0; i < l.outerSize(); ++i) {
    for (SparseMatrix::InnerIterator entry(l, i); entry; ++entry) {
      ASSERT_TRUE(std::isfinite(entry.value()));
      if (entry.row() == entry.col()) continue;
      EXPECT_GE(entry.value(), options.min_weight);
      EXPECT_LE(entry.value(), bound);
    }
  }
}

TEST(CotangentLaplacian, DoesNotDependOnTheOrderOfTriangles) {
  const TriangleSoup spindle = Spindle(3, 20, 1);
  const Eigen::MatrixXd l =
      CotangentLaplacian(spindle.points, spindle.triangles, {});
  const Triangles reversed = spindle.triangles.colwise().reverse();
  const Eigen::MatrixXd other =
      CotangentLaplacian(spindle.points, reversed, {});
  EXPECT_LT((l - other).cwiseAbs().maxCoeff(), kWeightRounding);
}

}  // namespace musclewarp
