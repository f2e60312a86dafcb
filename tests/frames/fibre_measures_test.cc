// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/fibre_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace musclewarp {
namespace {

// A straight fibre along x with points at the given places.
Points Fibre(const std::vector<double>& places, double y = 0) {
  Points fibre(places.size(), 3);
  for (size_t i = 0; i < places.size(); ++i) fibre.row(i) << places[i], y, 0;
  return fibre;
}

}  // namespace

TEST(FibreMeasures, SpreadIsThatOfTheEnds) {
  Points fan = Fibre({0, 50, 90}, 3);
  fan(2, 1) = 0;
  const FibreSpread spread = SpreadOf({Fibre({0, 100}, -3), fan});
  EXPECT_DOUBLE_EQ(spread.shortest, 50 + std::hypot(40, 3));
  EXPECT_DOUBLE_EQ(spread.at_origin, 3);
  EXPECT_DOUBLE_EQ(spread.at_insertion, std::hypot(5, 1.5));
  EXPECT_EQ(SpreadOf({}).shortest, 0);
}

// The second of three segments is twice as long as at rest: it lies in the
// second to the fourth fifth.
TEST(FibreMeasures, StretchIsSharedOutByLengthAtRest) {
  const std::array<double, 5> fifths =
      StretchByFifths({Fibre({0, 30, 70, 100})}, {Fibre({0, 30, 110, 140})});
  const double expected[] = {1, 1.5, 2, 1.5, 1};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(fifths[i], expected[i], 1e-12);
}

TEST(FibreMeasures, AtRestNothingIsStretched) {
  const std::vector<Points> rest = {Fibre({0, 7, 20}), Fibre({0, 30, 70, 99})};
  for (const double fifth : StretchByFifths(rest, rest)) {
    EXPECT_NEAR(fifth, 1, 1e-14);
  }
  for (const double fifth : StretchByFifths({}, {})) EXPECT_EQ(fifth, 1);
}

}  // namespace musclewarp
