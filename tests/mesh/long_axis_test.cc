// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/long_axis.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/mesh/transformed.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// Both ends in the order of z.
Points Sorted(Points ends) {
  if (ends(0, 2) > ends(1, 2)) ends.row(0).swap(ends.row(1));
  return ends;
}

TEST(LongAxis, OfASpindleEndsAtItsTips) {
  const TriangleSoup muscle = Spindle(8, 40, 3);
  Points tips(2, 3);
  tips << 0, 0, -40, 0, 0, 40;
  // Icospheres are symmetric but for rounding.
  EXPECT_LT((Sorted(LongAxis(muscle.points, muscle.triangles)) - tips).norm(),
            1e-9);
}

TEST(LongAxis, GoesAlongWithTheMesh) {
  const TriangleSoup box = Box(5, 20, 90);
  const Eigen::Affine3d motion =
      Eigen::Translation3d(1e3, -2e3, 500) *
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, -1).normalized());
  const Points moved =
      Sorted(LongAxis(Transformed(box.points, motion.matrix()), box.triangles));
  const Points expected =
      Sorted(Transformed(LongAxis(box.points, box.triangles), motion.matrix()));
  EXPECT_LT((moved - expected).norm(), 1e-7);  // of coordinates of 2000
}

// One half of the box has many more triangles than the other.
TEST(LongAxis, DoesNotDependOnTheDensityOfTheMesh) {
  const TriangleSoup coarse = Box(3, 4, 9);
  const TriangleSoup fine = LatticeBox(3, 4, 9);
  const Points a = Sorted(LongAxis(coarse.points, coarse.triangles));
  const Points b = Sorted(LongAxis(fine.points, fine.triangles));
  EXPECT_LT(((a.row(1) - a.row(0)) - (b.row(1) - b.row(0))).norm(), 1e-9);
}

}  // namespace
}  // namespace musclewarp
