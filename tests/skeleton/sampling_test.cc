// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/sampling.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

ActionLine BentLine() {
  ActionLine line;
  line.rest.resize(3, 3);
  line.rest << 0, 0, 0, 25, 0, 0, 25, 4, 0;
  return line;
}

}  // namespace

TEST(Sampling, HasEveryPointOfTheLineOnceAndNoWideGap) {
  const ActionLine line = BentLine();
  const std::vector<SegmentPoint> samples = SampleLines({line}, 10);
  // 25 mm in 3 pieces, 4 mm in one: 3 + 1 + 1 samples.
  ASSERT_EQ(samples.size(), 5u);
  for (size_t i = 0; i + 1 < samples.size(); ++i) {
    const double gap = (PointOnSegment(line.rest, samples[i + 1]) -
                        PointOnSegment(line.rest, samples[i]))
                           .norm();
    EXPECT_GT(gap, 0);
    EXPECT_LE(gap, 10);
  }
  EXPECT_EQ(PointOnSegment(line.rest, samples.front()), line.rest.row(0));
  EXPECT_EQ(PointOnSegment(line.rest, samples[3]), line.rest.row(1));
  EXPECT_EQ(PointOnSegment(line.rest, samples.back()), line.rest.row(2));
}

TEST(Sampling, CutsAnEndlessSegmentIntoABoundedNumberOfPieces) {
  const auto num_samples = [](double length, double spacing) {
    ActionLine line;
    line.rest.resize(2, 3);
    line.rest << 0, 0, 0, 0, 0, length;
    return SampleLines({line}, spacing).size();
  };
  EXPECT_EQ(num_samples(1e4, 10), 1001u);
  EXPECT_EQ(num_samples(1e4, 5), 2001u);  // not bounded yet
  EXPECT_EQ(num_samples(1e6, 10), 1001u);
  EXPECT_EQ(num_samples(1e300, 10), 1001u);
  EXPECT_EQ(num_samples(1e6, 1e5), 11u);
}

TEST(Sampling, GivesTheTargetTheSameParameters) {
  // Rounding of coordinates of some ten mm.
  constexpr double kRounding = 1e-13;
  const ActionLine line = BentLine();
  Points target = 2 * line.rest;
  target.rowwise() += Eigen::RowVector3d(1, 2, 3);
  for (const SegmentPoint& sample : SampleLines({line}, 3)) {
    const Eigen::RowVector3d expected =
        2 * PointOnSegment(line.rest, sample) + Eigen::RowVector3d(1, 2, 3);
    EXPECT_LT((PointOnSegment(target, sample) - expected).norm(), kRounding);
  }
}

}  // namespace musclewarp
