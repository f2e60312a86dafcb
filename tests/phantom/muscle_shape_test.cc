// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/muscle_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace musclewarp::phantom {
namespace {

TEST(MuscleShape, ATendonHasItsLengthAndThenBecomesBelly) {
  MuscleShape shape;
  shape.belly = 12;
  shape.tendon = 3;
  shape.tendon_fraction = 0.2;
  EXPECT_EQ(shape.HalfThickness(0), 3);
  EXPECT_EQ(shape.HalfThickness(0.19), 3);
  EXPECT_GT(shape.HalfThickness(0.35), 3);
  EXPECT_EQ(shape.HalfThickness(0.5), 12);
  EXPECT_EQ(shape.HalfThickness(0.81), 3);
  EXPECT_EQ(shape.MeanThickness(), 15);
}

TEST(MuscleShape, WidthsAreReachedAtEndsAndMiddle) {
  MuscleShape shape;
  shape.width = {4, 30, 8};
  EXPECT_EQ(shape.HalfWidth(0), 4);
  EXPECT_EQ(shape.HalfWidth(0.25), 17);
  EXPECT_EQ(shape.HalfWidth(0.5), 30);
  EXPECT_EQ(shape.HalfWidth(1), 8);
}

TEST(MuscleShape, DrawnShapesHaveTheSizesOfRealMuscles) {
  RandomDraws draws(1);
  int flat = 0;
  constexpr int kDraws = 500;
  for (int i = 0; i < kDraws; ++i) {
    const MuscleShape shape = DrawMuscleShape(1, &draws);
    flat += shape.IsFlat();
    EXPECT_GE(2 * shape.tendon, 4);
    EXPECT_LE(shape.tendon, shape.belly);
    EXPECT_LE(2 * shape.belly, 40);
    EXPECT_LE(shape.tendon_fraction, 0.2);
    for (const double depth : {shape.depth_in_bones, shape.depth_in_muscles}) {
      EXPECT_GE(depth, 0.5);
      EXPECT_LE(depth, 6);
    }
  }
  EXPECT_GT(flat, kDraws / 5);
  EXPECT_LT(flat, kDraws / 2);
}

TEST(MuscleShape, SmallShapesAreSmall) {
  RandomDraws draws(2);
  for (int i = 0; i < 200; ++i) {
    const MuscleShape shape = DrawMuscleShape(0, &draws);
    EXPECT_LE(shape.belly, 6);
    EXPECT_LE(*std::max_element(shape.width.begin(), shape.width.end()), 10);
  }
}

TEST(MuscleShape, CellsFitIntoTheThinnestPart) {
  RandomDraws draws(3);
  for (int i = 0; i < 200; ++i) {
    const MuscleShape shape = DrawMuscleShape(1, &draws);
    const double cell = DrawCellSize(shape, 150, &draws);
    EXPECT_GE(cell, 1.5);
    EXPECT_LE(cell, 5);
    EXPECT_LT(std::sqrt(3) * cell, 2 * shape.tendon);
  }
}

}  // namespace
}  // namespace musclewarp::phantom
