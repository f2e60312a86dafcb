// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/cotangent_laplacian.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "musclewarp/mesh/measures.h"
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
  options.weights = LaplacianWeights::kArea;
  options.length_scale = 3;
  const Eigen::MatrixXd by_area =
      CotangentLaplacian(soup.points, soup.triangles, options);
  options.weights = LaplacianWeights::kPaper;
  const Eigen::MatrixXd paper =
      CotangentLaplacian(soup.points, soup.triangles, options);
  // Edges of sqrt(8), so that faces measure 2 sqrt(3) and vertices share them.
  const double row = 3 / (2 * std::sqrt(2 * std::sqrt(3.0)));
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double weight = i == j ? -3 : 1;
      EXPECT_NEAR(
          by_area(i, j), row * weight * 2 / std::sqrt(3.0), kWeightRounding);
      EXPECT_NEAR(paper(i, j), weight / 3, kWeightRounding);
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
  options.weights = LaplacianWeights::kArea;
  options.length_scale = 2;
  const SparseMatrix l =
      CotangentLaplacian(sphere.points, sphere.triangles, options);
  const double largest_weight = 2 / std::tan(options.min_angle);
  const double mean_area = SurfaceArea(sphere.points, sphere.triangles) /
                           static_cast<double>(sphere.points.rows());
  const double largest_scale = 1 / std::sqrt(options.min_area * mean_area);
  for (int i = 0; i < l.outerSize(); ++i) {
    for (SparseMatrix::InnerIterator entry(l, i); entry; ++entry) {
      ASSERT_TRUE(std::isfinite(entry.value()));
      if (entry.row() == entry.col()) continue;
      EXPECT_GT(entry.value(), 0);
      EXPECT_LE(entry.value(), largest_scale * largest_weight);
    }
  }
}

// On a sphere laplace x is -2 n / r, so that the integral of its square is
// 16 pi whatever the radius.
TEST(CotangentLaplacian, ItsEnergyApproachesAnIntegral) {
  CotangentLaplacianOptions options;
  options.weights = LaplacianWeights::kArea;
  options.length_scale = 5;
  const double integral = 25 * 16 * std::acos(-1.0);
  std::vector<double> errors;
  for (const int levels : {1, 2, 3, 4}) {
    const TriangleSoup sphere = Icosphere(10, levels);
    const double energy =
        (CotangentLaplacian(sphere.points, sphere.triangles, options) *
         sphere.points)
            .squaredNorm();
    errors.push_back(std::abs(energy / integral - 1));
  }
  // Of second order: edges of half the length leave a quarter of the error.
  for (size_t i = 1; i < errors.size(); ++i) {
    EXPECT_LT(errors[i], errors[i - 1] / 3);
  }
  EXPECT_LT(errors.back(), 2e-3);
}

// The paper's energy falls with the area of a vertex instead.
TEST(CotangentLaplacian, ThePapersEnergyHasNoLimit) {
  CotangentLaplacianOptions options;
  options.weights = LaplacianWeights::kPaper;
  const auto energy = [&](int levels) {
    const TriangleSoup sphere = Icosphere(10, levels);
    return (CotangentLaplacian(sphere.points, sphere.triangles, options) *
            sphere.points)
        .squaredNorm();
  };
  EXPECT_NEAR(energy(3) / energy(4), 4, 0.1);
}

TEST(CotangentLaplacian, BothWeightsAgreeAtTwoHundredEvenVertices) {
  // 162 vertices, and so an energy of 162 / 200 times as much.
  const TriangleSoup sphere = Icosphere(10, 2);
  const auto energy = [&](LaplacianWeights weights) {
    CotangentLaplacianOptions options;
    options.weights = weights;
    return (CotangentLaplacian(sphere.points, sphere.triangles, options) *
            sphere.points)
        .squaredNorm();
  };
  EXPECT_NEAR(
      energy(LaplacianWeights::kArea) / energy(LaplacianWeights::kPaper),
      static_cast<double>(sphere.points.rows()) / 200,
      0.03);  // the triangles of an icosphere are not quite even
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
