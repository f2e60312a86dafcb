// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/row_products.h"

#if defined(__x86_64__) && defined(__GNUC__)
#define MUSCLEWARP_HAS_WIDE_PRODUCTS
#include <immintrin.h>
#endif

namespace musclewarp {
namespace {

// The same from the number `first` of each row and column on. The loops are
// written so that compilers use the registers that every processor has.
template <int Rows, typename Number>
void AddPlainDots(const Number* rows,
                  const double* columns,
                  Eigen::Index first,
                  Eigen::Index size,
                  double* results) {
  for (int r = 0; r < Rows; ++r) {
    const Number* const row = rows + r * size;
    for (int k = 0; k < 3; ++k) {
      const double* const column = columns + k * size;
      double sum = 0;
#pragma omp simd reduction(+ : sum)
      for (Eigen::Index j = first; j < size; ++j) sum += row[j] * column[j];
      results[3 * r + k] += sum;
    }
  }
}

template <int Rows, typename Number>
void AddPlainRows(const Number* rows,
                  const double* factors,
                  Eigen::Index first,
                  Eigen::Index size,
                  double* columns) {
  for (int k = 0; k < 3; ++k) {
    double* const column = columns + k * size;
#pragma omp simd
    for (Eigen::Index j = first; j < size; ++j) {
      double sum = column[j];
      for (int r = 0; r < Rows; ++r)
        sum += factors[3 * r + k] * rows[r * size + j];
      column[j] = sum;
    }
  }
}

#ifdef MUSCLEWARP_HAS_WIDE_PRODUCTS

constexpr int kLanes = 4;

__attribute__((target("avx2"))) inline __m256d LoadFour(const float* numbers) {
  return _mm256_cvtps_pd(_mm_loadu_ps(numbers));
}
__attribute__((target("avx2"))) inline __m256d LoadFour(const double* numbers) {
  return _mm256_loadu_pd(numbers);
}

// While the upper halves of wide registers are in use, all that follows may
// take twice as long. GCC 12 forgets to zero them before a call that ends a
// function.
__attribute__((target("avx2"))) inline void ZeroUpperHalves() {
  _mm256_zeroupper();
}

bool HasWideRegisters() {
  static const bool has =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return has;
}

template <int Rows, typename Number>
__attribute__((target("avx2,fma"))) void WideDots(const Number* rows,
                                                  const double* columns,
                                                  Eigen::Index size,
                                                  double* results) {
  __m256d sums[3 * Rows];
  for (__m256d& sum : sums) sum = _mm256_setzero_pd();
  Eigen::Index j = 0;
  for (; j + kLanes <= size; j += kLanes) {
    const __m256d x = _mm256_loadu_pd(columns + j);
    const __m256d y = _mm256_loadu_pd(columns + size + j);
    const __m256d z = _mm256_loadu_pd(columns + 2 * size + j);
    for (int r = 0; r < Rows; ++r) {
      const __m256d row = LoadFour(rows + r * size + j);
      sums[3 * r] = _mm256_fmadd_pd(row, x, sums[3 * r]);
      sums[3 * r + 1] = _mm256_fmadd_pd(row, y, sums[3 * r + 1]);
      sums[3 * r + 2] = _mm256_fmadd_pd(row, z, sums[3 * r + 2]);
    }
  }
  for (int i = 0; i < 3 * Rows; ++i) {
    double lanes[kLanes];
    _mm256_storeu_pd(lanes, sums[i]);
    results[i] = (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
  }
  ZeroUpperHalves();
  AddPlainDots<Rows>(rows, columns, j, size, results);
}

template <int Rows, typename Number>
__attribute__((target("avx2,fma"))) void AddWideRows(const Number* rows,
                                                     const double* factors,
                                                     Eigen::Index size,
                                                     double* columns) {
  Eigen::Index j = 0;
  for (; j + kLanes <= size; j += kLanes) {
    __m256d sums[3];
    for (int k = 0; k < 3; ++k) {
      sums[k] = _mm256_loadu_pd(columns + k * size + j);
    }
    for (int r = 0; r < Rows; ++r) {
      const __m256d row = LoadFour(rows + r * size + j);
      for (int k = 0; k < 3; ++k) {
        sums[k] =
            _mm256_fmadd_pd(_mm256_set1_pd(factors[3 * r + k]), row, sums[k]);
      }
    }
    for (int k = 0; k < 3; ++k) {
      _mm256_storeu_pd(columns + k * size + j, sums[k]);
    }
  }
  ZeroUpperHalves();
  AddPlainRows<Rows>(rows, factors, j, size, columns);
}

#endif  // MUSCLEWARP_HAS_WIDE_PRODUCTS

}  // namespace

template <int Rows, typename Number>
void Dots(const Number* rows,
          const double* columns,
          Eigen::Index size,
          double* results) {
#ifdef MUSCLEWARP_HAS_WIDE_PRODUCTS
  if (HasWideRegisters()) {
    WideDots<Rows>(rows, columns, size, results);
    return;
  }
#endif
  for (int i = 0; i < 3 * Rows; ++i) results[i] = 0;
  AddPlainDots<Rows>(rows, columns, 0, size, results);
}

template <int Rows, typename Number>
void AddRows(const Number* rows,
             const double* factors,
             Eigen::Index size,
             double* columns) {
#ifdef MUSCLEWARP_HAS_WIDE_PRODUCTS
  if (HasWideRegisters()) {
    AddWideRows<Rows>(rows, factors, size, columns);
    return;
  }
#endif
  AddPlainRows<Rows>(rows, factors, 0, size, columns);
}

template void Dots<1>(const float*, const double*, Eigen::Index, double*);
template void Dots<4>(const float*, const double*, Eigen::Index, double*);
template void Dots<1>(const double*, const double*, Eigen::Index, double*);
template void Dots<4>(const double*, const double*, Eigen::Index, double*);
template void AddRows<1>(const float*, const double*, Eigen::Index, double*);
template void AddRows<4>(const float*, const double*, Eigen::Index, double*);
template void AddRows<1>(const double*, const double*, Eigen::Index, double*);
template void AddRows<4>(const double*, const double*, Eigen::Index, double*);

}  // namespace musclewarp
