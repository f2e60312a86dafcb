// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/dense_product.h"

#include <glog/logging.h>

#include <algorithm>
#include <iterator>

#include "musclewarp/base/wide_registers.h"
#include "musclewarp/base/work_counts.h"

namespace musclewarp {
namespace {

// Rows are taken four at a time, so that the points are loaded once for all of
// them. Every sum has the same terms in the same order as with one row at a
// time, and so the same rounding.
constexpr int kRows = 4;

// results[3 r + k] = row r . column k, for four rows of `size` numbers and
// three columns, each of which follows the one before in memory.
MUSCLEWARP_WIDE void FourTimesThreeDots(const double* rows,
                                        const double* columns,
                                        Eigen::Index size,
                                        double* results) {
  const double *r0 = rows, *r1 = r0 + size, *r2 = r1 + size, *r3 = r2 + size;
  const double *x = columns, *y = x + size, *z = y + size;
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
  double x2 = 0, y2 = 0, z2 = 0, x3 = 0, y3 = 0, z3 = 0;
#pragma omp simd reduction(+ : x0, y0, z0, x1, y1, z1, x2, y2, z2, x3, y3, z3)
  for (Eigen::Index j = 0; j < size; ++j) {
    x0 += r0[j] * x[j];
    y0 += r0[j] * y[j];
    z0 += r0[j] * z[j];
    x1 += r1[j] * x[j];
    y1 += r1[j] * y[j];
    z1 += r1[j] * z[j];
    x2 += r2[j] * x[j];
    y2 += r2[j] * y[j];
    z2 += r2[j] * z[j];
    x3 += r3[j] * x[j];
    y3 += r3[j] * y[j];
    z3 += r3[j] * z[j];
  }
  const double sums[] = {x0, y0, z0, x1, y1, z1, x2, y2, z2, x3, y3, z3};
  std::copy(std::begin(sums), std::end(sums), results);
}

// The same for one row.
MUSCLEWARP_WIDE void ThreeDots(const double* row,
                               const double* columns,
                               Eigen::Index size,
                               double* results) {
  const double *x = columns, *y = x + size, *z = y + size;
  double sum_x = 0, sum_y = 0, sum_z = 0;
#pragma omp simd reduction(+ : sum_x, sum_y, sum_z)
  for (Eigen::Index j = 0; j < size; ++j) {
    sum_x += row[j] * x[j];
    sum_y += row[j] * y[j];
    sum_z += row[j] * z[j];
  }
  results[0] = sum_x;
  results[1] = sum_y;
  results[2] = sum_z;
}

// column k += factors[3 r + k] * row r, for four rows, one after the other.
MUSCLEWARP_WIDE void AddFourTimesThree(const double* rows,
                                       const double* factors,
                                       Eigen::Index size,
                                       double* columns) {
  const double *r0 = rows, *r1 = r0 + size, *r2 = r1 + size, *r3 = r2 + size;
  const double* const f = factors;
  double *x = columns, *y = x + size, *z = y + size;
#pragma omp simd
  for (Eigen::Index j = 0; j < size; ++j) {
    x[j] = x[j] + f[0] * r0[j] + f[3] * r1[j] + f[6] * r2[j] + f[9] * r3[j];
    y[j] = y[j] + f[1] * r0[j] + f[4] * r1[j] + f[7] * r2[j] + f[10] * r3[j];
    z[j] = z[j] + f[2] * r0[j] + f[5] * r1[j] + f[8] * r2[j] + f[11] * r3[j];
  }
}

// The same for one row.
MUSCLEWARP_WIDE void AddThree(const double* row,
                              const double* factors,
                              Eigen::Index size,
                              double* columns) {
  double *x = columns, *y = x + size, *z = y + size;
#pragma omp simd
  for (Eigen::Index j = 0; j < size; ++j) {
    x[j] += factors[0] * row[j];
    y[j] += factors[1] * row[j];
    z[j] += factors[2] * row[j];
  }
}

// Calls four(i) for every four rows and one(i) for those that are left.
template <typename Four, typename One>
void ForRows(Eigen::Index count, const Four& four, const One& one) {
  Eigen::Index i = 0;
  for (; i + kRows <= count; i += kRows) four(i);
  for (; i < count; ++i) one(i);
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
  const auto multiply = [&](auto kernel) {
    return [&, kernel](Eigen::Index i) {
      for (size_t k = 0; k < sets.size(); ++k) {
        kernel(matrix.row(i).data(),
               columns[k].data(),
               matrix.cols(),
               products[k].row(i).data());
      }
    };
  };
  ForRows(matrix.rows(), multiply(FourTimesThreeDots), multiply(ThreeDots));
  CountWork(WorkUnit::kMatrixEntries, matrix.size());
  return products;
}

std::vector<Points> TransposedProducts(const RowMajorMatrix& matrix,
                                       const std::vector<Points>& sets) {
  std::vector<Eigen::MatrixX3d> sums;
  for (const Points& points : sets) {
    CHECK_EQ(matrix.rows(), points.rows());
    sums.push_back(Eigen::MatrixX3d::Zero(matrix.cols(), 3));
  }
  const auto add = [&](auto kernel) {
    return [&, kernel](Eigen::Index i) {
      for (size_t k = 0; k < sets.size(); ++k) {
        kernel(matrix.row(i).data(),
               sets[k].row(i).data(),
               matrix.cols(),
               sums[k].data());
      }
    };
  };
  ForRows(matrix.rows(), add(AddFourTimesThree), add(AddThree));
  CountWork(WorkUnit::kMatrixEntries, matrix.size());
  return {sums.begin(), sums.end()};
}

}  // namespace musclewarp
