// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/triangle_stretch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "support/meshes.h"

namespace musclewarp {

TEST(TriangleStretch, RigidMotionsHaveNone) {
  const TriangleSoup spindle = Spindle(12, 60, 2);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  const StretchMeasures measures =
      MeasureStretch(spindle.points, spindle.points * turn, spindle.triangles);
  // Rounding: the root of a discriminant near zero keeps half of the digits.
  EXPECT_NEAR(measures.largest, 1, 1e-6);
  EXPECT_NEAR(measures.mean, 1, 1e-6);
  EXPECT_EQ(measures.area_beyond_anatomy, 0);
  EXPECT_EQ(measures.largest_patch, 0);
}

TEST(TriangleStretch, IsTheLargerSingularValueOfALinearMap) {
  const TriangleSoup box = LatticeBox(3, 3, 3);
  Eigen::Matrix3d map;
  map << 1, 0.4, 0, 0, 1.2, 0, 0, 0, 0.5;
  const Points deformed = box.points * map.transpose();
  const Eigen::VectorXd stretches =
      TriangleStretches(box.points, deformed, box.triangles);
  const double of_top =
      map.topLeftCorner<2, 2>().jacobiSvd().singularValues()[0];
  for (Eigen::Index f = 0; f < stretches.size(); ++f) {
    if ((box.points(box.triangles.row(f), 2).array() == 3).all()) {
      EXPECT_NEAR(stretches[f], of_top, 1e-12);
    }
  }
  EXPECT_NEAR(stretches.maxCoeff(), of_top, 1e-12);
}

TEST(TriangleStretch, SpikesAreNoLargePatches) {
  // A lattice box of 6 x 600 mm^2 on a side; one vertex in the middle of a side
  // is pulled out: the six triangles around it are a patch of 3 mm^2.
  TriangleSoup box = LatticeBox(10, 10, 10);
  Points deformed = box.points;
  for (Eigen::Index v = 0; v < deformed.rows(); ++v) {
    if (deformed.row(v) == Eigen::RowVector3d(5, 5, 10)) deformed(v, 2) += 4;
  }
  const StretchMeasures spike =
      MeasureStretch(box.points, deformed, box.triangles);
  EXPECT_NEAR(spike.largest_patch, 3, 1e-12);
  EXPECT_NEAR(spike.area_of_patches, 3, 1e-12);
  EXPECT_GT(spike.largest, 4);
  EXPECT_NEAR(spike.quantile_99, 1, 1e-12);
  EXPECT_GT(spike.quantile_999, 2);
  EXPECT_LT((spike.patch_place - Eigen::RowVector3d(5, 5, 10)).norm(), 2);
  // All of it drawn out is a patch as large as four of its sides.
  deformed = box.points;
  deformed.col(0) *= 2.5;
  const StretchMeasures drawn =
      MeasureStretch(box.points, deformed, box.triangles);
  EXPECT_NEAR(drawn.largest_patch, 400, 1e-9);
  EXPECT_NEAR(drawn.area_beyond_anatomy, 400, 1e-9);
  EXPECT_NEAR(drawn.quantile_99, 2.5, 1e-12);
  EXPECT_NEAR(drawn.mean, 2, 1e-9);
}

TEST(LargestTornPatch, WhatThePoseAsksForIsNotTorn) {
  const TriangleSoup box = LatticeBox(10, 10, 10);
  Points free = box.points;
  free.col(0) *= 2.5;
  EXPECT_EQ(LargestTornPatch(box.points, free, free, box.triangles).area, 0);
  // Four of the sides lie along the first axis.
  const auto torn_at = [&](double stretch) {
    Points deformed = box.points;
    deformed.col(0) *= stretch;
    return LargestTornPatch(box.points, deformed, free, box.triangles).area;
  };
  EXPECT_EQ(torn_at(2.69), 0);
  EXPECT_NEAR(torn_at(2.71), 400, 1e-9);
  // Without contact the box is at rest.
  free = box.points;
  EXPECT_EQ(torn_at(1.99), 0);
  EXPECT_NEAR(torn_at(2.01), 400, 1e-9);
}

TEST(TriangleStretch, SliversHaveNone) {
  Points rest(3, 3), deformed(3, 3);
  rest << 0, 0, 0, 10, 0, 0, 5, 0.1, 0;
  deformed << 0, 0, 0, 10, 0, 0, 5, 3, 0;
  Triangles triangles(1, 3);
  triangles << 0, 1, 2;
  EXPECT_EQ(TriangleStretches(rest, deformed, triangles)[0], 1);
  rest(2, 1) = 0;
  EXPECT_EQ(TriangleStretches(rest, deformed, triangles)[0], 1);
  rest(2, 1) = 1;
  EXPECT_NEAR(TriangleStretches(rest, deformed, triangles)[0], 3, 1e-12);
}

TEST(TriangleStretch, QuantilesCountWeights) {
  const Eigen::Vector3d values(3, 1, 2), weights(1, 98, 1);
  EXPECT_EQ(WeightedQuantiles(values, weights, {0.5, 0.985, 1}),
            (std::vector<double>{1, 2, 3}));
}

}  // namespace musclewarp
