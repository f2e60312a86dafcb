// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/dense_product.h"

#include <gtest/gtest.h>

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

// Sums of up to 1500 terms below 1.
constexpr double kProductRounding = 1e-12;

}  // namespace

TEST(DenseProduct, IsTheProductForAllSizes) {
  for (const int rows : {1, 7, 512, 513, 1500}) {
    for (const int columns : {1, 3, 64, 187}) {
      const RowMajorMatrix matrix = RandomMatrix(rows, columns);
      const Points few = RandomMatrix(columns, 3);
      const Points many = RandomMatrix(rows, 3);
      EXPECT_LT((Product(matrix, few) - matrix.lazyProduct(few))
                    .cwiseAbs()
                    .maxCoeff(),
                kProductRounding);
      EXPECT_LT((TransposedProduct(matrix, many) -
                 matrix.transpose().lazyProduct(many))
                    .cwiseAbs()
                    .maxCoeff(),
                kProductRounding);
    }
  }
}

TEST(DenseProduct, SeveralSetsTogetherAreTheSameToTheBit) {
  const RowMajorMatrix matrix = RandomMatrix(70, 23);
  const std::vector<Points> few = {RandomMatrix(23, 3), RandomMatrix(23, 3)};
  const std::vector<Points> many = {RandomMatrix(70, 3), RandomMatrix(70, 3)};
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(Products(matrix, few)[k], Product(matrix, few[k]));
    EXPECT_EQ(TransposedProducts(matrix, many)[k],
              TransposedProduct(matrix, many[k]));
  }
  EXPECT_TRUE(Products(matrix, {}).empty());
}

}  // namespace musclewarp
