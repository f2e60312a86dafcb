// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/fibre_bands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A straight fibre beside the origin with some points.
Points FibreAt(double x, int points = 5) {
  Points fibre(points, 3);
  for (int i = 0; i < points; ++i) {
    fibre.row(i) << x, 0, 100.0 * i / (points - 1);
  }
  return fibre;
}

TEST(FibreBands, AreFibresThatLieBesideEachOther) {
  std::vector<Points> fibres;
  for (const double x : {0, 40, 1, 41, 2, 80, 42, 81}) {
    fibres.push_back(FibreAt(x, 4 + static_cast<int>(x) % 3));
  }
  EXPECT_THAT(
      FibreBands(fibres, 3),
      ElementsAre(
          ElementsAre(0, 2, 4), ElementsAre(1, 3, 6), ElementsAre(5, 7)));
}

TEST(FibreBands, HoldEveryFibreOnce) {
  std::vector<Points> fibres;
  for (int i = 0; i < 40; ++i) fibres.push_back(FibreAt(i * i % 37));
  for (int count = 1; count <= 6; ++count) {
    const auto bands = FibreBands(fibres, count);
    EXPECT_THAT(bands, SizeIs(count));
    std::vector<int> all;
    for (const auto& band : bands) {
      EXPECT_TRUE(std::is_sorted(band.begin(), band.end()));
      all.insert(all.end(), band.begin(), band.end());
    }
    std::sort(all.begin(), all.end());
    std::vector<int> expected(40);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(all, expected);
  }
}

TEST(FibreBands, AreFewerWhereThereAreFewerFibres) {
  EXPECT_THAT(FibreBands({}, 3), IsEmpty());
  EXPECT_THAT(FibreBands({FibreAt(0)}, 3), ElementsAre(ElementsAre(0)));
  // Two fibres on each other are one band.
  EXPECT_THAT(FibreBands({FibreAt(0), FibreAt(0)}, 2),
              ElementsAre(ElementsAre(0, 1)));
}

TEST(FibreBands, LieAroundTheirMean) {
  const std::vector<Points> fibres = {FibreAt(0), FibreAt(50, 7), FibreAt(2)};
  EXPECT_TRUE(MeanFibre(fibres, {0, 2}).col(0).isConstant(1));
  const std::vector<Points> lines = {FibreAt(40), FibreAt(10, 2), FibreAt(60)};
  EXPECT_EQ(NearestLine(fibres, {0, 2}, lines), 1);
  EXPECT_EQ(NearestLine(fibres, {1}, {FibreAt(20), FibreAt(60)}), 1);
}

}  // namespace
}  // namespace musclewarp
