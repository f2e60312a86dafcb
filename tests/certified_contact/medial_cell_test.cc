// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/medial_cell.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// How near to the border the way there ends.
constexpr double kPlace = 1e-3;

MedialCellOptions Options() {
  MedialCellOptions options;
  options.margin = 0.2;
  options.voxel_size = 0.5;
  return options;
}

}  // namespace

TEST(MedialCell, OfTwoMusclesMeetsAtTheMedialSurface) {
  // They share the layer 4 < z < 5.
  const SearchableMesh lower(LatticeBox(6, 6, 5));
  const SearchableMesh upper(MovedBy(LatticeBox(6, 6, 4), {0, 0, 4}));
  const MedialCell below(Options(), lower, {&upper}, {});
  const MedialCell above(Options(), upper, {&lower}, {});
  // Half the margin on either side of z = 4.5.
  EXPECT_NEAR(below.SignedDistance({3, 3, 4.4}), 0, 1e-12);
  EXPECT_NEAR(above.SignedDistance({3, 3, 4.6}), 0, 1e-12);
  EXPECT_NEAR(below.SignedDistance({3, 3, 4.7}), 0.3, 1e-12);
  EXPECT_NEAR(below.SignedDistance({3, 3, 4.2}), -0.2, 1e-12);
  EXPECT_LT((below.Inward({3, 3, 4.7}) - RowVector3d(0, 0, -1)).norm(), 1e-9);
  const Points up = above.Project(upper.points());
  const Points down = below.Project(lower.points());
  for (Eigen::Index v = 0; v < upper.points().rows(); ++v) {
    const RowVector3d p = upper.points().row(v);
    if (p[2] > 5) {
      EXPECT_EQ(up.row(v), p);
    }
    EXPECT_LE(above.SignedDistance(up.row(v)), 1e-9);
  }
  for (Eigen::Index v = 0; v < lower.points().rows(); ++v) {
    EXPECT_LE(below.SignedDistance(down.row(v)), 1e-9);
  }
  EXPECT_GT((up - upper.points()).norm(), 1);
}

TEST(MedialCell, KeepsOffBonesByHalfTheMargin) {
  const SearchableMesh muscle(LatticeBox(6, 6, 4));
  const SearchableMesh bone(MovedBy(Box(12, 12, 3), {3, 3, -0.5}));
  const MedialCell cell(Options(), muscle, {}, {&bone});
  const Points points = cell.Project(muscle.points());
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const RowVector3d p = muscle.points().row(v);
    if (p[2] >= 2) {
      EXPECT_EQ(points.row(v), p);
    } else {
      EXPECT_GE(points(v, 2), 1 + 0.1 - kPlace);
    }
  }
}

TEST(MedialCell, IsWhatAPlateDoesNotCutOff) {
  // A plate a quarter thick: thinner than a voxel. Most of the muscle is above.
  const SearchableMesh muscle(LatticeBox(6, 6, 9));
  const SearchableMesh plate(MovedBy(Box(12, 12, 0.25), {3, 3, 2.525}));
  const MedialCell cell(Options(), muscle, {}, {&plate});
  const Points points = cell.Project(muscle.points());
  EXPECT_GT(points.col(2).minCoeff(), 2.65);
  EXPECT_EQ(points.col(2).maxCoeff(), 9);
}

TEST(MedialCell, LeavesWhatIsApart) {
  const SearchableMesh muscle(Icosphere(5, 3));
  TriangleSoup far = Icosphere(5, 3);
  far.points.rowwise() += RowVector3d(10.5, 0, 0);
  const SearchableMesh other(far);
  const MedialCell cell(Options(), muscle, {&other}, {});
  EXPECT_EQ(cell.Project(muscle.points()), muscle.points());
}

TEST(MedialCell, IsBoundedByNoSurfaceFartherThanTheRange) {
  const SearchableMesh muscle(Icosphere(5, 3));
  const SearchableMesh other(MovedBy(Icosphere(5, 3), {14, 0, 0}));
  const MedialCell cell(Options(), muscle, {&other}, {});
  EXPECT_EQ(cell.SignedDistance({0, 0, 0}), -Options().range);
  EXPECT_EQ(cell.Inward({0, 0, 0}), RowVector3d::Zero());
}

TEST(MedialCellOptions, NameWhatIsWrong) {
  MedialCellOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error));
  options.voxel_size = 0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "MedialCellOptions::voxel_size is 0, allowed: above 0");
}

}  // namespace musclewarp
