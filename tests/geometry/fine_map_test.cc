// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/fine_map.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>
#include <random>
#include <vector>

namespace musclewarp {
namespace {

RowMajorMatrix RandomMatrix(Eigen::Index rows, Eigen::Index columns) {
  std::mt19937 engine(1);
  RowMajorMatrix matrix(rows, columns);
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    matrix.data()[i] = engine() / 4294967296.0 - 0.5;
  }
  return matrix;
}

// Points of a muscle: up to 200 mm apart, 1 m from the origin.
Points RandomPoints(Eigen::Index count) {
  Points points = 200 * RandomMatrix(count, 3);
  return points.rowwise() + Eigen::RowVector3d(300, -200, 900);
}

// A map whose rows sum to 1, as those of coordinates do.
RowMajorMatrix RandomCoordinates(Eigen::Index rows, Eigen::Index columns) {
  RowMajorMatrix matrix = RandomMatrix(rows, columns).cwiseAbs();
  for (Eigen::Index i = 0; i < rows; ++i) matrix.row(i) /= matrix.row(i).sum();
  return matrix;
}

RowMajorMatrix AllRows(const FineMap& map) {
  std::vector<int> rows(map.rows());
  std::iota(rows.begin(), rows.end(), 0);
  return RowsOf(map, rows);
}

// Sums of up to 1500 terms below 1.
constexpr double kProductRounding = 1e-12;

TEST(FineMap, ProductsAreThoseOfItsRowsForAllSizes) {
  for (const int rows : {1, 7, 512, 513, 1500}) {
    for (const int columns : {4, 5, 64, 187}) {
      const FineMap map =
          MakeFineMap(RandomMatrix(rows, columns), RandomMatrix(columns, 3));
      const RowMajorMatrix matrix = AllRows(map);
      const Points few = RandomMatrix(columns, 3);
      const Points many = RandomMatrix(rows, 3);
      EXPECT_LT(
          (Product(map, few) - matrix.lazyProduct(few)).cwiseAbs().maxCoeff(),
          kProductRounding);
      EXPECT_LT(
          (TransposedProduct(map, many) - matrix.transpose().lazyProduct(many))
              .cwiseAbs()
              .maxCoeff(),
          kProductRounding);
    }
  }
}

TEST(FineMap, SeveralSetsTogetherAreTheSameToTheBit) {
  const FineMap map = MakeFineMap(RandomMatrix(70, 23), RandomMatrix(23, 3));
  const std::vector<Points> few = {RandomMatrix(23, 3), RandomMatrix(23, 3)};
  const std::vector<Points> many = {RandomMatrix(70, 3), RandomMatrix(70, 3)};
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(Products(map, few)[k], Product(map, few[k]));
    EXPECT_EQ(TransposedProducts(map, many)[k],
              TransposedProduct(map, many[k]));
  }
  EXPECT_TRUE(Products(map, {}).empty());
}

// Rest, rigid motions and stretches of the whole come out as in double
// precision: 1e-10 mm is a hundred times its rounding of coordinates of 1 m,
// and a millionth of that of single precision.
TEST(FineMap, AffineMotionsAreAsExactAsInDoublePrecision) {
  const Points coarse = RandomPoints(187);
  const RowMajorMatrix matrix = RandomCoordinates(500, 187);
  const FineMap map = MakeFineMap(matrix, coarse);
  Eigen::Matrix3d stretch =
      Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  for (int i = 0; i < 2; ++i) {
    const Points moved =
        (coarse * stretch).rowwise() + Eigen::RowVector3d(50, 60, 70);
    EXPECT_LT((Product(map, moved) - matrix * moved).cwiseAbs().maxCoeff(),
              1e-10);
    stretch.col(1) *= 1.7;
  }
}

// Other motions are off by the rounding of what coarse points move against each
// other: 2^-24 of each weight, so that 1e-6 of 5 mm is a wide bound.
TEST(FineMap, OtherMotionsAreRoundedByTheirSize) {
  const Points coarse = RandomPoints(187);
  const RowMajorMatrix matrix = RandomCoordinates(500, 187);
  const Points moved = coarse + 10 * RandomMatrix(187, 3);
  EXPECT_LT((Product(MakeFineMap(matrix, coarse), moved) - matrix * moved)
                .cwiseAbs()
                .maxCoeff(),
            5e-6);
}

}  // namespace
}  // namespace musclewarp
