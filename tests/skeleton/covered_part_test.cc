// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/covered_part.h"

#include <gtest/gtest.h>

#include "musclewarp/skeleton/sampling.h"

namespace musclewarp {
namespace {

// A line along z from 0 to 300 mm.
ActionLine LongLine() {
  ActionLine line;
  line.rest.resize(3, 3);
  line.rest << 0, 0, 0, 0, 0, 150, 0, 0, 300;
  return line;
}

// Points of a muscle around that line, between two heights.
Points MuscleBetween(double lower, double upper) {
  Points points(4, 3);
  points << 9, 0, lower, -9, 0, lower, 9, 0, upper, 0, 9, upper;
  return points;
}

TEST(PartAlong, IsBetweenTheOutermostPlacesOnTheLine) {
  const CoveredPart part = PartAlong(LongLine().rest, MuscleBetween(40, 210));
  EXPECT_DOUBLE_EQ(part.begin, 40);
  EXPECT_DOUBLE_EQ(part.end, 210);
  EXPECT_DOUBLE_EQ(part.length, 300);
}

TEST(PartAlong, IsTheWholeLineOfAMuscleThatIsLonger) {
  const CoveredPart part = PartAlong(LongLine().rest, MuscleBetween(-20, 320));
  EXPECT_EQ(part.begin, 0);
  EXPECT_EQ(part.end, part.length);
}

TEST(SamplesAlong, LeaveOutWhatIsFarBeyondTheMuscle) {
  const std::vector<ActionLine> lines = {LongLine(), LongLine()};
  const std::vector<SegmentPoint> all = SampleLines(lines, 10);
  const std::vector<SegmentPoint> along =
      SamplesAlong(all, lines, MuscleBetween(40, 210));
  // 15 mm beyond either end: from 30 to 220 in steps of 10, on each line.
  ASSERT_EQ(along.size(), 2 * 20u);
  EXPECT_NEAR(PointOnSegment(lines[0].rest, along.front())[2], 30, 1e-12);
  EXPECT_NEAR(PointOnSegment(lines[1].rest, along.back())[2], 220, 1e-12);
  EXPECT_EQ(along[20].line, 1);
}

TEST(SamplesAlong, KeepALineThatWouldHaveNoneLeft) {
  const std::vector<ActionLine> lines = {LongLine()};
  const std::vector<SegmentPoint> all = SampleLines(lines, 200);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(SamplesAlong(all, lines, MuscleBetween(60, 80)).size(), 3u);
}

}  // namespace
}  // namespace musclewarp
