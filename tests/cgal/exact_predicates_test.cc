// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/exact_predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>

namespace musclewarp {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;
using Eigen::RowVector3d;
using Integers = std::array<std::int64_t, 3>;

// Coordinates are whole numbers up to this, which doubles hold exactly, while
// the terms of the determinants need three times as many digits as they have.
constexpr std::int64_t kLargest = std::int64_t{1} << 50;

RowVector3d Real(const Integers& p) {
  return RowVector3d(static_cast<double>(p[0]),
                     static_cast<double>(p[1]),
                     static_cast<double>(p[2]));
}

int ExactSign(const Integers& a,
              const Integers& b,
              const Integers& c,
              const Integers& d) {
  std::array<cpp_int, 3> u, v, w;
  for (int k = 0; k < 3; ++k) {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    w[k] = d[k] - a[k];
  }
  const cpp_int determinant = (u[1] * v[2] - u[2] * v[1]) * w[0] +
                              (u[2] * v[0] - u[0] * v[2]) * w[1] +
                              (u[0] * v[1] - u[1] * v[0]) * w[2];
  return determinant.sign();
}

int ExactSign2d(const Integers& a, const Integers& b, const Integers& c) {
  const cpp_int left = cpp_int(b[0] - a[0]) * (c[1] - a[1]);
  const cpp_int right = cpp_int(b[1] - a[1]) * (c[0] - a[0]);
  return cpp_int(left - right).sign();
}

int Orientation2dOf(const Integers& a, const Integers& b, const Integers& c) {
  const RowVector3d p = Real(a), q = Real(b), r = Real(c);
  return Orientation2d(p[0], p[1], q[0], q[1], r[0], r[1]);
}

Integers RandomInteger(std::mt19937* random) {
  std::uniform_int_distribution<std::int64_t> coordinate(-kLargest / 8,
                                                         kLargest / 8);
  Integers p;
  for (std::int64_t& x : p) x = coordinate(*random);
  return p;
}

// Four points, of which the last is in the plane of the others up to `noise` in
// each coordinate.
std::array<Integers, 4> NearlyFlat(int noise, std::mt19937* random) {
  std::uniform_int_distribution<int> quarter(-4, 4);
  std::uniform_int_distribution<int> shift(-noise, noise);
  const Integers a = RandomInteger(random);
  const Integers u = RandomInteger(random);
  const Integers v = RandomInteger(random);
  const int s = quarter(*random), t = quarter(*random);
  std::array<Integers, 4> points = {a, a, a, a};
  for (int k = 0; k < 3; ++k) {
    // u and v are divided by 8 so that all coordinates stay in range.
    points[1][k] += 4 * (u[k] / 8);
    points[2][k] += 4 * (v[k] / 8);
    points[3][k] += s * (u[k] / 8) + t * (v[k] / 8) + shift(*random);
  }
  return points;
}

// Returns x and y with a x + b y = gcd(a, b), by Euclid's algorithm.
std::array<std::int64_t, 2> Bezout(std::int64_t a, std::int64_t b) {
  if (b == 0) return {1, 0};
  const auto [x, y] = Bezout(b, a % b);
  return {y, x - a / b * y};
}

// Three points in the xy plane whose determinant is `determinant`, far below
// the rounding errors of its terms.
std::array<Integers, 3> NearlyInLine(int determinant, std::mt19937* random) {
  std::uniform_int_distribution<int> multiple(-2, 2);
  const Integers a = RandomInteger(random);
  Integers u = RandomInteger(random);
  const std::int64_t divisor = std::gcd(u[0], u[1]);
  for (int k = 0; k < 2; ++k) u[k] /= divisor;
  // u x w = 1. The two products may be too large for 64 bits, but their sum is
  // 1 or -1, also modulo 2^64.
  const auto [w1, minus_w0] = Bezout(u[0], u[1]);
  const auto product = [](std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) * static_cast<std::uint64_t>(y);
  };
  const auto sign =
      static_cast<std::int64_t>(product(u[0], w1) + product(u[1], minus_w0));
  const Integers w = {-sign * minus_w0, sign * w1, 0};
  const int s = multiple(*random);
  std::array<Integers, 3> points = {a, a, a};
  for (int k = 0; k < 2; ++k) {
    points[1][k] += u[k];
    points[2][k] += s * u[k] + determinant * w[k];
  }
  return points;
}

}  // namespace

TEST(ExactPredicates, SignsByHand) {
  const RowVector3d o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
  EXPECT_EQ(Orientation(o, x, y, RowVector3d(0, 0, 1)), 1);
  EXPECT_EQ(Orientation(o, x, y, RowVector3d(5, 7, -1e-300)), -1);
  EXPECT_EQ(Orientation(o, x, y, RowVector3d(5, 7, 0)), 0);
  EXPECT_EQ(Orientation2d(0, 0, 1, 0, 0, 1), 1);
  EXPECT_EQ(Orientation2d(0, 0, 0, 1, 1, 0), -1);
  EXPECT_EQ(Orientation2d(0, 0, 1, 1, 3, 3), 0);
}

TEST(ExactPredicates, SignsOneUlpFromZero) {
  const RowVector3d a(0, 0, 0), b(1, 1e-3, 0.3), c(0.1, 1, 0.7);
  for (const double s : {0.1, 0.3, 0.7}) {
    const RowVector3d d = s * b + s * c;
    const cpp_rational exact =
        cpp_rational(b[0]) * (cpp_rational(c[1]) * cpp_rational(d[2]) -
                              cpp_rational(c[2]) * cpp_rational(d[1])) -
        cpp_rational(b[1]) * (cpp_rational(c[0]) * cpp_rational(d[2]) -
                              cpp_rational(c[2]) * cpp_rational(d[0])) +
        cpp_rational(b[2]) * (cpp_rational(c[0]) * cpp_rational(d[1]) -
                              cpp_rational(c[1]) * cpp_rational(d[0]));
    EXPECT_EQ(Orientation(a, b, c, d), exact.sign());
    EXPECT_EQ(Orientation(a, c, b, d), -exact.sign());
  }
  const double x = std::nextafter(0.5, 1);
  EXPECT_EQ(Orientation2d(0, 0, 1, 1, 0.5, 0.5), 0);
  EXPECT_EQ(Orientation2d(0, 0, 1, 1, 0.5, x), 1);
  EXPECT_EQ(Orientation2d(0, 0, 1, 1, x, 0.5), -1);
}

TEST(ExactPredicates, OrientationIsThatOfIntegersOnNearlyFlatPoints) {
  std::mt19937 random(1);
  std::array<int, 3> counts = {0, 0, 0};
  for (int i = 0; i < 3000; ++i) {
    const auto p = NearlyFlat(/*noise=*/i % 3, &random);
    const int expected = ExactSign(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(Orientation(Real(p[0]), Real(p[1]), Real(p[2]), Real(p[3])),
              expected)
        << i;
    ++counts[expected + 1];
  }
  // Points of all three kinds were tried.
  EXPECT_GT(*std::min_element(counts.begin(), counts.end()), 500);
}

TEST(ExactPredicates, Orientation2dIsThatOfIntegersOnNearlyCollinearPoints) {
  std::mt19937 random(2);
  for (int i = 0; i < 3000; ++i) {
    const auto p = NearlyInLine(/*determinant=*/i % 3 - 1, &random);
    const int expected = ExactSign2d(p[0], p[1], p[2]);
    ASSERT_EQ(expected, i % 3 - 1);
    ASSERT_EQ(Orientation2dOf(p[0], p[1], p[2]), expected) << i;
  }
}

// Points around (0.5, 0.5), one unit in the last place apart, and two points of
// the diagonal whose differences with them are rounded: the example of Kettner
// et al., "Classroom Examples of Robustness Problems in Geometric Computations"
// (2008), in units of 2^-53.
TEST(ExactPredicates, Orientation2dIsThatOfIntegersWhereDifferencesAreRounded) {
  constexpr std::int64_t kOne = std::int64_t{1} << 53;
  const Integers b = {12 * kOne, 12 * kOne, 0};
  const Integers c = {24 * kOne, 24 * kOne, 0};
  for (int i = 0; i < 64; ++i) {
    for (int k = 0; k < 64; ++k) {
      const Integers a = {kOne / 2 + i, kOne / 2 + k, 0};
      ASSERT_EQ(Orientation2dOf(a, b, c), ExactSign2d(a, b, c))
          << i << " " << k;
      ASSERT_EQ(Orientation2dOf(b, c, a), ExactSign2d(b, c, a))
          << i << " " << k;
    }
  }
}

TEST(ExactPredicates, PermutationsChangeTheSignByTheirParity) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const auto p = NearlyFlat(/*noise=*/1, &random);
    const int sign = ExactSign(p[0], p[1], p[2], p[3]);
    std::array<int, 4> order = {0, 1, 2, 3};
    do {
      int inversions = 0;
      for (int k = 0; k < 4; ++k) {
        for (int m = k + 1; m < 4; ++m) inversions += order[k] > order[m];
      }
      EXPECT_EQ(Orientation(Real(p[order[0]]),
                            Real(p[order[1]]),
                            Real(p[order[2]]),
                            Real(p[order[3]])),
                inversions % 2 == 0 ? sign : -sign);
    } while (std::next_permutation(order.begin(), order.end()));

    const auto q = NearlyInLine(/*determinant=*/1, &random);
    const int sign2d = ExactSign2d(q[0], q[1], q[2]);
    EXPECT_EQ(Orientation2dOf(q[1], q[2], q[0]), sign2d);
    EXPECT_EQ(Orientation2dOf(q[2], q[0], q[1]), sign2d);
    EXPECT_EQ(Orientation2dOf(q[1], q[0], q[2]), -sign2d);
    EXPECT_EQ(Orientation2dOf(q[0], q[2], q[1]), -sign2d);
    EXPECT_EQ(Orientation2dOf(q[2], q[1], q[0]), -sign2d);
  }
}

TEST(ExactPredicates, CoordinatesWhoseProductsUnderflow) {
  // Scaling by a power of two is exact. Products of three of these coordinates
  // are below the smallest normal number, 2^-1022.
  constexpr double kScale = 0x1p-400;
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    const auto p = NearlyFlat(/*noise=*/i % 3, &random);
    EXPECT_EQ(Orientation(kScale * Real(p[0]),
                          kScale * Real(p[1]),
                          kScale * Real(p[2]),
                          kScale * Real(p[3])),
              ExactSign(p[0], p[1], p[2], p[3]));
  }
}

TEST(ExactPredicates, TheFilterAgreesWithExactArithmeticAlone) {
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    const RowVector3d a = Real(RandomInteger(&random));
    const RowVector3d b = Real(RandomInteger(&random));
    const RowVector3d c = Real(RandomInteger(&random));
    const RowVector3d d = Real(RandomInteger(&random));
    EXPECT_EQ(Orientation(a, b, c, d), internal::ExactOrientation(a, b, c, d));
    EXPECT_EQ(Orientation2d(a[0], a[1], b[0], b[1], c[0], c[1]),
              internal::ExactOrientation2d(a[0], a[1], b[0], b[1], c[0], c[1]));
  }
}

}  // namespace musclewarp
