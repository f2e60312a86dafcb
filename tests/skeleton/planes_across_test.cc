// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/planes_across.h"

#include <gtest/gtest.h>

#include <cmath>

namespace musclewarp {
namespace {

TEST(PlanesAcross, StandUprightOnAStraightLineAtEqualDistances) {
  Points line(3, 3);
  line << 1, 2, 3, 1, 2, 8, 1, 2, 43;
  const SectionPlanes planes = PlanesAcross(line, 4);
  ASSERT_EQ(planes.places.rows(), 4);
  for (int i = 0; i < 4; ++i) {
    // 40 mm in four parts of 10 mm.
    EXPECT_NEAR(planes.places(i, 2), 8 + 10 * i, 1e-12);
    EXPECT_LT((planes.normals.row(i).normalized() - Eigen::RowVector3d(0, 0, 1))
                  .norm(),
              1e-12);
  }
}

// The planes of a quarter of a circle all contain its axis.
TEST(PlanesAcross, TurnWithTheLine) {
  constexpr int kPoints = 201;
  Points line(kPoints, 3);
  for (int i = 0; i < kPoints; ++i) {
    const double angle = M_PI / 2 * i / (kPoints - 1);
    line.row(i) << 30 * std::cos(angle), 30 * std::sin(angle), 0;
  }
  const SectionPlanes planes = PlanesAcross(line, 10);
  for (int i = 0; i < 10; ++i) {
    const Eigen::RowVector3d normal = planes.normals.row(i).normalized();
    // At the ends the chord is cut off, to one side of 0.05 of the length.
    const double allowed = i == 0 || i == 9 ? 30 * 0.04 : 1e-3;
    EXPECT_NEAR(normal.dot(planes.places.row(i)), 0, allowed);
  }
}

TEST(PlanesAcross, LeavesOutWhereTheLineGoesBack) {
  Points line(3, 3);
  line << 0, 0, 0, 0, 0, 50, 0, 0, 0;
  const SectionPlanes planes = PlanesAcross(line, 3);
  EXPECT_EQ(planes.places.rows(), 2);
}

TEST(PlanesAcross, WantsALineAndPlanes) {
  EXPECT_DEATH(PlanesAcross(Points::Zero(2, 3), 3), "length");
  EXPECT_DEATH(PlanesAcross(Points::Identity(2, 3), 0), "count");
}

}  // namespace
}  // namespace musclewarp
