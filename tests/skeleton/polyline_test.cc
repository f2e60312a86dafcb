// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/polyline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace musclewarp {
namespace {

// Rounding of coordinates of some ten mm.
constexpr double kCoordinateRounding = 1e-13;

// A corner: 3 mm along x, then 4 mm along y.
Points Corner() {
  Points points(3, 3);
  points << 1, 2, 5, 4, 2, 5, 4, 6, 5;
  return points;
}

double Difference(const Points& a, const Points& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

}  // namespace

TEST(Polyline, LengthIsTheSumOfItsSegments) {
  EXPECT_EQ(PolylineLength(Corner()), 7);
  EXPECT_EQ(PolylineLength(Corner().topRows(1)), 0);
  EXPECT_EQ(PolylineLength(Points(0, 3)), 0);
}

TEST(Polyline, SamplesAreAtEqualDistancesAlongIt) {
  // A point every 1.75 mm: the second is on the first segment, the others are
  // on the second one.
  Points expected(5, 3);
  expected << 1, 2, 5, 2.75, 2, 5, 4, 2.5, 5, 4, 4.25, 5, 4, 6, 5;
  EXPECT_LT(Difference(Resampled(Corner(), 5), expected), kCoordinateRounding);
}

TEST(Polyline, EndsAreKept) {
  for (const int count : {2, 3, 7, 100}) {
    const Points samples = Resampled(Corner(), count);
    ASSERT_EQ(samples.rows(), count);
    EXPECT_EQ(samples.topRows<1>(), Corner().topRows<1>());
    EXPECT_EQ(samples.bottomRows<1>(), Corner().bottomRows<1>());
  }
}

TEST(Polyline, SharesAreThoseOfTheLength) {
  const Eigen::VectorXd shares = SharesAlong(Corner());
  ASSERT_EQ(shares.size(), 3);
  EXPECT_EQ(shares[0], 0);
  EXPECT_DOUBLE_EQ(shares[1], 3.0 / 7);
  EXPECT_EQ(shares[2], 1);
  EXPECT_LT(Difference(PointsAtShares(Corner(), shares), Corner()),
            kCoordinateRounding);
  EXPECT_EQ(SharesAlong(Corner().row(1).replicate<3, 1>()),
            Eigen::VectorXd::Zero(3));
}

TEST(Polyline, SamplesOfSamplesOfASegmentAreTheSame) {
  const Points samples = Resampled(Corner().topRows(2), 9);
  EXPECT_LT(Difference(Resampled(samples, 9), samples), kCoordinateRounding);
}

TEST(Polyline, TheOtherDirectionGivesTheSameSamples) {
  const Points forward = Resampled(Corner(), 11);
  const Points backward = Resampled(Corner().colwise().reverse(), 11);
  EXPECT_LT(Difference(backward.colwise().reverse(), forward),
            kCoordinateRounding);
}

TEST(Polyline, RepeatedPointsDoNotMatter) {
  Points repeated(5, 3);
  repeated << Corner().row(0), Corner().row(0), Corner().row(1),
      Corner().row(1), Corner().row(2);
  EXPECT_EQ(Resampled(repeated, 8), Resampled(Corner(), 8));
  const Points at_one_place = Corner().row(1).replicate<3, 1>();
  EXPECT_EQ(Resampled(at_one_place, 3), at_one_place);
}

TEST(Polyline, TheSharpestTurnIsThatOfTwoSegments) {
  EXPECT_EQ(SharpestTurn(Corner().topRows(2)), 0);
  Points turns(5, 3);  // by a quarter, not at all, and all the way back
  turns << 0, 0, 0, 3, 4, 0, 3, 4, 12, 3, 4, 12, 3, 4, 10;
  const double half_turn = std::acos(-1.0);
  EXPECT_NEAR(SharpestTurn(turns.topRows(3)), half_turn / 2, 1e-15);
  EXPECT_NEAR(SharpestTurn(turns.topRows(4)), half_turn / 2, 1e-15);
  EXPECT_NEAR(SharpestTurn(turns), half_turn, 1e-15);
}

}  // namespace musclewarp
