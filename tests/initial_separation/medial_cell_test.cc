// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/medial_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "initial_separation/solid.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// How near to the border the way there ends.
constexpr double kPlace = 1e-3;

MedialCellOptions CellOptions() {
  MedialCellOptions options;
  options.margin = 0.2;
  options.voxel_size = 0.5;
  return options;
}

}  // namespace

TEST(MedialCell, OfTwoMusclesMeetsAtTheMedialSurface) {
  // They share the layer 4 < z < 5.
  const Solid lower(LatticeBox(6, 6, 5));
  const Solid upper(MovedBy(LatticeBox(6, 6, 4), {0, 0, 4}));
  const MedialCell below(CellOptions(), lower.distance, {&upper.distance}, {});
  const MedialCell above(CellOptions(), upper.distance, {&lower.distance}, {});
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
  const Solid muscle(LatticeBox(6, 6, 4));
  const Solid bone(MovedBy(Box(12, 12, 3), {3, 3, -0.5}));
  const MedialCell cell(CellOptions(), muscle.distance, {}, {&bone.distance});
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
  const Solid muscle(LatticeBox(6, 6, 9));
  const Solid plate(MovedBy(Box(12, 12, 0.25), {3, 3, 2.525}));
  const MedialCell cell(CellOptions(), muscle.distance, {}, {&plate.distance});
  const Points points = cell.Project(muscle.points());
  EXPECT_GT(points.col(2).minCoeff(), 2.65);
  EXPECT_EQ(points.col(2).maxCoeff(), 9);
}

TEST(MedialCell, OfSeveralMusclesAreThoseOfEach) {
  const Solid lower(LatticeBox(6, 6, 5));
  const Solid upper(MovedBy(LatticeBox(6, 6, 4), {0, 0, 4}));
  const MedialCell below(CellOptions(), lower.distance, {&upper.distance}, {});
  const MedialCell above(CellOptions(), upper.distance, {&lower.distance}, {});
  const std::vector<Points> both =
      MedialCell::Project({&below, &above}, {&lower.points(), &upper.points()});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0], below.Project(lower.points()));
  EXPECT_EQ(both[1], above.Project(upper.points()));
}

TEST(MedialCell, LeavesWhatIsApart) {
  const Solid muscle(Icosphere(5, 3));
  TriangleSoup far = Icosphere(5, 3);
  far.points.rowwise() += RowVector3d(10.5, 0, 0);
  const Solid other(far);
  const MedialCell cell(CellOptions(), muscle.distance, {&other.distance}, {});
  EXPECT_EQ(cell.Project(muscle.points()), muscle.points());
}

TEST(MedialCell, IsBoundedByNoSurfaceFartherThanTheRange) {
  const Solid muscle(Icosphere(5, 3));
  const Solid other(MovedBy(Icosphere(5, 3), {14, 0, 0}));
  const MedialCell cell(CellOptions(), muscle.distance, {&other.distance}, {});
  EXPECT_EQ(cell.SignedDistance({0, 0, 0}), -CellOptions().range);
  EXPECT_EQ(cell.Inward({0, 0, 0}), RowVector3d::Zero());
}

TEST(MedialCell, TheRegionsOfTwoMusclesAddUpToMoreThanNothing) {
  // Two that overlap by 4, and one that lies mostly within the first.
  const Solid a(Icosphere(8, 3));
  const Solid b(MovedBy(Icosphere(8, 3), {12, 0, 0}));
  const Solid c(MovedBy(Icosphere(3, 2), {-6, 0, 0}));
  const SolidDistance *of_a = &a.distance, *of_b = &b.distance,
                      *of_c = &c.distance;
  const MedialCell cells[] = {{CellOptions(), *of_a, {of_b, of_c}, {}},
                              {CellOptions(), *of_b, {of_a, of_c}, {}},
                              {CellOptions(), *of_c, {of_a, of_b}, {}}};
  const Points places = 20 * RandomPoints(3000, 1);
  for (const auto p : places.rowwise()) {
    const double at_a = cells[0].RegionDistance(p);
    const double at_b = cells[1].RegionDistance(p);
    const double at_c = cells[2].RegionDistance(p);
    const double least = CellOptions().margin / 2 - kDistanceRounding;
    EXPECT_GE(at_a + at_b, least) << p;
    EXPECT_GE(at_a + at_c, least) << p;
    EXPECT_GE(at_b + at_c, least) << p;
    // What is outside the muscle does not belong to it.
    EXPECT_GE(at_a, of_a->At(p, 100) - kDistanceRounding);
  }
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
