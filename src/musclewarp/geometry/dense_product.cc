// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/dense_product.h"

#include <glog/logging.h>

namespace musclewarp {
namespace {

// The compiler makes a version for processors with wide registers, which is
// chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define MUSCLEWARP_WIDE __attribute__((target_clones("avx2,fma", "default")))
#else
#define MUSCLEWARP_WIDE
#endif

// result = (row . x, row . y, row . z)
MUSCLEWARP_WIDE void ThreeDots(const double* row,
                               const double* x,
                               const double* y,
                               const double* z,
                               Eigen::Index size,
                               double* result) {
  double sum_x = 0;
  double sum_y = 0;
  double sum_z = 0;
#pragma omp simd reduction(+ : sum_x, sum_y, sum_z)
  for (Eigen::Index j = 0; j < size; ++j) {
    sum_x += row[j] * x[j];
    sum_y += row[j] * y[j];
    sum_z += row[j] * z[j];
  }
  result[0] = sum_x;
  result[1] = sum_y;
  result[2] = sum_z;
}

// (x, y, z) += factors * row
MUSCLEWARP_WIDE void AddThree(const double* row,
                              const double* factors,
                              Eigen::Index size,
                              double* x,
                              double* y,
                              double* z) {
#pragma omp simd
  for (Eigen::Index j = 0; j < size; ++j) {
    x[j] += factors[0] * row[j];
    y[j] += factors[1] * row[j];
    z[j] += factors[2] * row[j];
  }
}

}  // namespace

Points Product(const RowMajorMatrix& matrix, const Points& points) {
  return Products(matrix, {points})[0];
}

Points TransposedProduct(const RowMajorMatrix& matrix, const Points& points) {
  return TransposedProducts(matrix, {points})[0];
}

std::vector<Points> Products(const RowMajorMatrix& matrix,
                             const std::vector<Points>& sets) {
  std::vector<Eigen::MatrixX3d> columns;  // column-major
  std::vector<Points> products;
  for (const Points& points : sets) {
    CHECK_EQ(matrix.cols(), points.rows());
    columns.emplace_back(points);
    products.emplace_back(matrix.rows(), 3);
  }
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (size_t k = 0; k < sets.size(); ++k) {
      ThreeDots(matrix.row(i).data(),
                columns[k].col(0).data(),
                columns[k].col(1).data(),
                columns[k].col(2).data(),
                matrix.cols(),
                products[k].row(i).data());
    }
  }
  return products;
}

std::vector<Points> TransposedProducts(const RowMajorMatrix& matrix,
                                       const std::vector<Points>& sets) {
  std::vector<Eigen::MatrixX3d> sums;
  for (const Points& points : sets) {
    CHECK_EQ(matrix.rows(), points.rows());
    sums.push_back(Eigen::MatrixX3d::Zero(matrix.cols(), 3));
  }
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (size_t k = 0; k < sets.size(); ++k) {
      AddThree(matrix.row(i).data(),
               sets[k].row(i).data(),
               matrix.cols(),
               sums[k].col(0).data(),
               sums[k].col(1).data(),
               sums[k].col(2).data());
    }
  }
  return {sums.begin(), sums.end()};
}

}  // namespace musclewarp
