// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/own_region.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// How near to the border the way there ends.
constexpr double kPlace = 1e-3;

OwnRegionOptions Options() {
  OwnRegionOptions options;
  options.margin = 0.2;
  options.cell = 0.5;
  return options;
}

}  // namespace

TEST(OwnRegion, OfTwoMusclesMeetsAtTheMidSurface) {
  // They share the layer 4 < z < 5.
  const SearchableMesh lower(LatticeBox(6, 6, 5));
  const SearchableMesh upper(MovedBy(LatticeBox(6, 6, 4), {0, 0, 4}));
  const OwnRegion below(Options(), lower, {&upper}, {});
  const OwnRegion above(Options(), upper, {&lower}, {});
  // Half the margin on either side of z = 4.5.
  EXPECT_NEAR(below.Excess({3, 3, 4.4}), 0, 1e-12);
  EXPECT_NEAR(above.Excess({3, 3, 4.6}), 0, 1e-12);
  EXPECT_NEAR(below.Excess({3, 3, 4.7}), 0.3, 1e-12);
  EXPECT_NEAR(below.Excess({3, 3, 4.2}), -0.2, 1e-12);
  EXPECT_LT((below.Inward({3, 3, 4.7}) - RowVector3d(0, 0, -1)).norm(), 1e-9);
  const Points up = above.Project(upper.points());
  const Points down = below.Project(lower.points());
  for (Eigen::Index v = 0; v < upper.points().rows(); ++v) {
    const RowVector3d p = upper.points().row(v);
    if (p[2] > 5) {
      EXPECT_EQ(up.row(v), p);
    }
    EXPECT_LE(above.Excess(up.row(v)), 1e-9);
  }
  for (Eigen::Index v = 0; v < lower.points().rows(); ++v) {
    EXPECT_LE(below.Excess(down.row(v)), 1e-9);
  }
  EXPECT_GT((up - upper.points()).norm(), 1);
}

TEST(OwnRegion, KeepsOffBonesByHalfTheMargin) {
  const SearchableMesh muscle(LatticeBox(6, 6, 4));
  const SearchableMesh bone(MovedBy(Box(12, 12, 3), {3, 3, -0.5}));
  const OwnRegion region(Options(), muscle, {}, {&bone});
  const Points points = region.Project(muscle.points());
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const RowVector3d p = muscle.points().row(v);
    if (p[2] >= 2) {
      EXPECT_EQ(points.row(v), p);
    } else {
      EXPECT_GE(points(v, 2), 1 + 0.1 - kPlace);
    }
  }
}

TEST(OwnRegion, IsWhatAPlateDoesNotCutOff) {
  // A plate a quarter thick: thinner than a cell. Most of the muscle is above.
  const SearchableMesh muscle(LatticeBox(6, 6, 9));
  const SearchableMesh plate(MovedBy(Box(12, 12, 0.25), {3, 3, 2.525}));
  const OwnRegion region(Options(), muscle, {}, {&plate});
  const Points points = region.Project(muscle.points());
  EXPECT_GT(points.col(2).minCoeff(), 2.65);
  EXPECT_EQ(points.col(2).maxCoeff(), 9);
}

TEST(OwnRegion, LeavesWhatIsApart) {
  const SearchableMesh muscle(Icosphere(5, 3));
  TriangleSoup far = Icosphere(5, 3);
  far.points.rowwise() += RowVector3d(10.5, 0, 0);
  const SearchableMesh other(far);
  const OwnRegion region(Options(), muscle, {&other}, {});
  EXPECT_EQ(region.Project(muscle.points()), muscle.points());
}

}  // namespace musclewarp
