// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/thin_product.h"

#include <gtest/gtest.h>

#include <vector>

namespace musclewarp {
namespace {

// Sums of up to 200 terms below 1.
constexpr double kRounding = 1e-12;

double Largest(const Points& difference) {
  return difference.cwiseAbs().maxCoeff();
}

TEST(ThinProduct, IsTheProductForAllSizes) {
  for (const int rows : {1, 3, 4, 7, 200}) {
    for (const int columns : {1, 4, 5, 64, 187}) {
      const RowMajorMatrix matrix = RowMajorMatrix::Random(rows, columns);
      const Points right = Points::Random(columns, 3);
      const Points left = Points::Random(rows, 3);
      EXPECT_LT(Largest(ThinProduct(matrix, right) - matrix.lazyProduct(right)),
                kRounding);
      EXPECT_LT(Largest(ThinTransposedProduct(matrix, left) -
                        matrix.transpose().lazyProduct(left)),
                kRounding);
    }
  }
}

TEST(ThinProduct, TakesSomeRowsInAnyOrder) {
  const RowMajorMatrix matrix = RowMajorMatrix::Random(20, 13);
  const std::vector<int> rows = {7, 2, 2, 19};
  const RowMajorMatrix some = matrix(rows, Eigen::all);
  const Points right = Points::Random(13, 3), left = Points::Random(4, 3);
  EXPECT_LT(Largest(ThinProduct(matrix, rows, right) - some.lazyProduct(right)),
            kRounding);
  EXPECT_LT(Largest(ThinTransposedProduct(matrix, rows, left) -
                    some.transpose().lazyProduct(left)),
            kRounding);
}

TEST(ThinProduct, OfNoRowsIsEmptyOrZero) {
  const RowMajorMatrix none(0, 5);
  EXPECT_EQ(ThinProduct(none, Points::Ones(5, 3)).rows(), 0);
  EXPECT_EQ(ThinTransposedProduct(none, Points(0, 3)), Points::Zero(5, 3));
}

}  // namespace
}  // namespace musclewarp
