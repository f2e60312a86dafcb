// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/muscle_state.h"

#include <gtest/gtest.h>

#include "support/muscles.h"

namespace musclewarp {
namespace {

// Of W X_0, mm.
constexpr double kStateRounding = 1e-11;

// Row i is (i, i, i) + by.
Points Numbered(int count, double by) {
  Points points(count, 3);
  for (int i = 0; i < count; ++i) points.row(i).setConstant(i + by);
  return points;
}

}  // namespace

TEST(HeldVertices, AreTheMarkedOnesWhereTheyAre) {
  const HeldVertices held = HeldVertices::Of(Numbered(4, 0), {0, 1, 0, 1});
  EXPECT_FALSE(held.IsEmpty());
  EXPECT_EQ(held.vertices, (std::vector<int>{1, 3}));
  EXPECT_EQ(held.positions.row(0), Numbered(4, 0).row(1));
  EXPECT_EQ(held.positions.row(1), Numbered(4, 0).row(3));
  EXPECT_TRUE(HeldVertices::Of(Numbered(2, 0), {0, 0}).IsEmpty());
}

TEST(HeldVertices, GoBackAndLeaveTheOthers) {
  const HeldVertices held = HeldVertices::Of(Numbered(4, 0), {0, 1, 0, 1});
  Points points = Numbered(4, 10);
  held.PutBack(&points);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(points.row(i), Numbered(4, i % 2 ? 0 : 10).row(i));
  }
}

TEST(HeldVertices, HaveNoGradient) {
  const HeldVertices held = HeldVertices::Of(Numbered(4, 0), {0, 1, 0, 1});
  Points gradient = Numbered(4, 10);
  held.ClearRows(&gradient);
  for (int i = 0; i < 4; ++i) {
    if (i % 2) {
      EXPECT_TRUE(gradient.row(i).isZero(0));
    } else {
      EXPECT_EQ(gradient.row(i), Numbered(4, 10).row(i));
    }
  }
}

TEST(FinePoints, FollowTheCoarseVertices) {
  const MuscleModel model = SpindleModel();
  MuscleState state{model.coarse_rest, {}};
  EXPECT_LT((FinePoints(model, state) - model.fine_rest).cwiseAbs().maxCoeff(),
            kStateRounding);
  state.coarse.rowwise() += Eigen::RowVector3d(1, 2, 3);
  const Points moved = model.fine_rest.rowwise() + Eigen::RowVector3d(1, 2, 3);
  EXPECT_LT((FinePoints(model, state) - moved).cwiseAbs().maxCoeff(),
            kStateRounding);
}

TEST(FinePoints, IncludeTheOffset) {
  const MuscleModel model = SpindleModel();
  const int count = static_cast<int>(model.fine_rest.rows());
  MuscleState state{model.coarse_rest, {}};
  const Points without = FinePoints(model, state);
  state.corrections.fine_offset = Numbered(count, 0.5);
  EXPECT_EQ(FinePoints(model, state), without + Numbered(count, 0.5));
}

}  // namespace musclewarp
