// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/thin_product.h"

#include <glog/logging.h>

#include "musclewarp/geometry/row_products.h"

namespace musclewarp {

Points ThinProduct(const RowMajorMatrix& matrix, const Points& points) {
  CHECK_EQ(matrix.cols(), points.rows());
  const Eigen::MatrixX3d columns = points;
  Points product(matrix.rows(), 3);
  const auto multiply = [&](auto kernel) {
    return [&, kernel](Eigen::Index i) {
      kernel(matrix.data() + i * matrix.cols(),
             columns.data(),
             matrix.cols(),
             product.data() + 3 * i);
    };
  };
  ForRows(matrix.rows(), multiply(Dots<4, double>), multiply(Dots<1, double>));
  return product;
}

Points ThinTransposedProduct(const RowMajorMatrix& matrix,
                             const Points& points) {
  CHECK_EQ(matrix.rows(), points.rows());
  Eigen::MatrixX3d sums = Eigen::MatrixX3d::Zero(matrix.cols(), 3);
  const auto add = [&](auto kernel) {
    return [&, kernel](Eigen::Index i) {
      kernel(matrix.data() + i * matrix.cols(),
             points.data() + 3 * i,
             matrix.cols(),
             sums.data());
    };
  };
  ForRows(matrix.rows(), add(AddRows<4, double>), add(AddRows<1, double>));
  return sums;
}

Points ThinProduct(const RowMajorMatrix& matrix,
                   const std::vector<int>& rows,
                   const Points& points) {
  CHECK_EQ(matrix.cols(), points.rows());
  const Eigen::MatrixX3d columns = points;
  Points product(rows.size(), 3);
  for (size_t k = 0; k < rows.size(); ++k) {
    Dots<1>(matrix.data() + rows[k] * matrix.cols(),
            columns.data(),
            matrix.cols(),
            product.data() + 3 * k);
  }
  return product;
}

Points ThinTransposedProduct(const RowMajorMatrix& matrix,
                             const std::vector<int>& rows,
                             const Points& points) {
  CHECK_EQ(static_cast<Eigen::Index>(rows.size()), points.rows());
  Eigen::MatrixX3d sums = Eigen::MatrixX3d::Zero(matrix.cols(), 3);
  for (size_t k = 0; k < rows.size(); ++k) {
    AddRows<1>(matrix.data() + rows[k] * matrix.cols(),
               points.data() + 3 * k,
               matrix.cols(),
               sums.data());
  }
  return sums;
}

}  // namespace musclewarp
