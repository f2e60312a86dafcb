// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/ankle.h"

#include <gtest/gtest.h>

#include "joints/ideal_surfaces.h"
#include "musclewarp/base/angles.h"
#include "support/made_bones.h"

namespace musclewarp {
namespace {

// Triangles of 2 mm pass 2^2 / (8 * 20) = 0.03 mm within the dome, which over
// its 28 mm is a sixteenth of a degree; its ends, rounded over 3 mm, and the
// neck, which meets it in front, pull as much again.
constexpr double kAnkleAngle = RadiansOf(0.2);
constexpr double kAnkleOffset = 0.2;  // mm

TEST(FitAnkle, FindsTheAxisOfTheDomeInAnyOrientation) {
  const MadeAnkle ankle = RightAnkle(3, 2);
  const SurfacePoints talus = SampleSurface(ankle.talus);
  const SurfacePoints tibia = SampleSurface(ankle.tibia);
  for (const int seed : {0, 1, 2, 3}) {
    const Eigen::Isometry3d motion =
        seed == 0 ? Eigen::Isometry3d::Identity() : RandomMotion(seed);
    const Axis axis = MovedBy(motion, ankle.axis);
    const auto fit = FitAnkle(MovedBy(motion, talus), MovedBy(motion, tibia));
    ASSERT_TRUE(fit);
    EXPECT_LT(AngleBetween(fit->cylinder.axis.direction, axis.direction),
              kAnkleAngle);
    EXPECT_LT(OffsetFrom(axis, fit->cylinder.axis.point).norm(), kAnkleOffset);
    EXPECT_NEAR(fit->cylinder.radius, kMadeDomeRadius, kAnkleOffset);
    // The point is at the middle of the dome, whose edges the neck cuts a
    // little.
    EXPECT_LT((fit->cylinder.axis.point - axis.point).norm(), 2);
    EXPECT_LT(fit->spread, 0.3);
  }
}

TEST(FitAnkle, CoversMoreOfTheDomeThanLooksAtTheTibia) {
  const MadeAnkle ankle = RightAnkle(3, 2);
  const auto fit =
      FitAnkle(SampleSurface(ankle.talus), SampleSurface(ankle.tibia));
  ASSERT_TRUE(fit);
  // The roof is 40 mm wide: the arc of a hollow of 23 mm is 120 degrees. The
  // dome goes on before and behind it, for half a turn and more.
  EXPECT_GT(fit->angle, RadiansOf(150));
  EXPECT_LT(fit->angle, RadiansOf(300));
}

TEST(FitAnkle, FindsNothingIfTheBonesAreApart) {
  const MadeAnkle ankle = RightAnkle(3, 2);
  const SurfacePoints talus = SampleSurface(ankle.talus);
  Eigen::Isometry3d up = Eigen::Isometry3d::Identity();
  up.translation().z() = 20;
  EXPECT_FALSE(FitAnkle(talus, MovedBy(up, SampleSurface(ankle.tibia))));
  EXPECT_FALSE(FitAnkle(talus, {}));
  EXPECT_FALSE(FitAnkle({}, talus));
}

// The talus as it is has a ball of 12 mm in front, but no hollow below.
TEST(FitSubtalar, FindsNothingWithoutAHollowFacet) {
  const MadeAnkle ankle = RightAnkle(3, 2);
  const SurfacePoints talus = SampleSurface(ankle.talus);
  EXPECT_FALSE(FitSubtalar(talus, SampleSurface(ankle.tibia)));
  EXPECT_FALSE(FitSubtalar(talus, {}));
}

}  // namespace
}  // namespace musclewarp
