// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/path_beyond.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

// 30 mm up, then 40 mm to the side.
Points Bend() {
  Points path(3, 3);
  path << 0, 0, 0, 0, 0, 30, 40, 0, 30;
  return path;
}

TEST(PartsBeyond, IsThatOfBothPartsOutsideOfTheMuscle) {
  Points carried(3, 3);
  carried << 0, 0, 5, 0, 0, 30, 25, 0, 30;
  const PartsBeyond beyond = FindPartsBeyond(Bend(), carried);
  EXPECT_NEAR(beyond.length, 5 + 15, 1e-12);
  EXPECT_EQ(beyond.points_before, 1);
  EXPECT_EQ(beyond.points_after, 1);
}

// Carried and beyond are the whole, wherever the muscle begins and ends.
TEST(PartsBeyond, CompletesTheCarriedPart) {
  for (const double from : {0.0, 7.0, 29.0}) {
    for (const double to : {1.0, 20.0, 40.0}) {
      Points carried(3, 3);
      carried << 0, 0, from, 0, 0, 30, to, 0, 30;
      EXPECT_NEAR(FindPartsBeyond(Bend(), carried).length + (30 - from) + to,
                  70,
                  1e-12);
    }
  }
}

TEST(PartsBeyond, IsNoneOfAPathThatIsCarriedWhole) {
  EXPECT_EQ(FindPartsBeyond(Bend(), Bend()).length, 0);
}

// As of a scene whose rest pose is not that of the defaults of its model.
TEST(PartsBeyond, IsNoneIfTheMuscleIsNotOnThePath) {
  Points carried(2, 3);
  carried << 0, 0, 5, 0, 5.1, 25;
  EXPECT_EQ(FindPartsBeyond(Bend(), carried).length, 0);
  carried << 0, 0, 25, 0, 0, 5;  // the other way round
  EXPECT_EQ(FindPartsBeyond(Bend(), carried).length, 0);
  EXPECT_EQ(FindPartsBeyond(Bend(), Points(0, 3)).length, 0);
  EXPECT_EQ(FindPartsBeyond(Points(0, 3), carried).length, 0);
}

}  // namespace
}  // namespace musclewarp
