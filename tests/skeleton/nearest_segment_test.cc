// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/nearest_segment.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

std::vector<ActionLine> TwoLines() {
  ActionLine bent;
  bent.rest.resize(3, 3);
  bent.rest << 0, 0, 0, 10, 0, 0, 10, 10, 0;
  ActionLine apart;
  apart.rest.resize(2, 3);
  apart.rest << 0, 0, 50, 10, 0, 50;
  return {bent, apart};
}

}  // namespace

TEST(NearestSegment, FindsLineSegmentAndPlace) {
  const SegmentPoint place = NearestSegment({12, 4, 1}, TwoLines());
  EXPECT_EQ(place.line, 0);
  EXPECT_EQ(place.segment, 1);
  EXPECT_DOUBLE_EQ(place.t, 0.4);
  EXPECT_EQ(NearestSegment({5, 0, 30}, TwoLines()).line, 1);
}

TEST(NearestSegment, StaysOnTheSegment) {
  EXPECT_EQ(NearestSegment({-7, 1, 0}, TwoLines()).t, 0);
  EXPECT_EQ(NearestSegment({10, 99, 0}, TwoLines()).t, 1);
}

TEST(NearestSegment, TakesTheFirstOfEqualOnes) {
  // The corner belongs to both segments.
  EXPECT_EQ(NearestSegment({10, 0, 0}, TwoLines()).segment, 0);
}

}  // namespace musclewarp
