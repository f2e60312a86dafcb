// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/final_fix.h"

#include <gtest/gtest.h>

#include "paper_contact/lone_body.h"
#include "support/meshes.h"

namespace musclewarp {

TEST(FinalFix, LeavesWhatIsApart) {
  LoneBody a(LatticeBox(2, 2, 2), true);
  LoneBody b(MovedBy(LatticeBox(2, 2, 2), {0, 0, 2.5}), true);
  EXPECT_FALSE(PushOut({}, &a.body, &b.body));
  EXPECT_EQ(a.body.points(), a.shape.rest);
}

TEST(FinalFix, PutsVerticesOnTheClosestPoint) {
  LoneBody muscle(MovedBy(LatticeBox(2, 2, 2), {3, 3, 3.75}), true);
  LoneBody bone(LatticeBox(8, 8, 4), false);
  const std::vector<int> inside = bone.body.Inside(muscle.shape.rest);
  ASSERT_EQ(inside.size(), 9u);
  PaperContactOptions options;
  EXPECT_TRUE(PushOut(options, &muscle.body, &bone.body));
  for (const int v : inside) {
    const Eigen::RowVector3d expected(muscle.shape.rest(v, 0),
                                      muscle.shape.rest(v, 1),
                                      4 + options.clearance);
    EXPECT_LT((muscle.body.points().row(v) - expected).norm(), 1e-12);
  }
  EXPECT_TRUE(bone.body.Inside(muscle.body.points()).empty());
}

TEST(FinalFix, AnObstaclesTipPushesTheTriangleItCameThrough) {
  TriangleSoup large = LatticeBox(1, 1, 1);
  large.points.leftCols(2) *= 20;
  LoneBody muscle(large, true);
  TriangleSoup tip = UnitTetrahedron();
  tip.points.col(2) *= 0.3;
  tip.points.rowwise() += Eigen::RowVector3d(12, 4, -0.2);
  LoneBody bone(tip, false);
  ASSERT_TRUE(bone.body.Inside(muscle.shape.rest).empty());
  ASSERT_EQ(muscle.body.Inside(tip.points).size(), 1u);
  EXPECT_TRUE(PushOut({}, &muscle.body, &bone.body));
  EXPECT_TRUE(muscle.body.Inside(tip.points).empty());
  // The lower side alone has moved, by about as much as the tip came in.
  const Points moves = muscle.body.points() - muscle.shape.rest;
  for (Eigen::Index v = 0; v < moves.rows(); ++v) {
    if (muscle.shape.rest(v, 2) == 1) {
      EXPECT_TRUE(moves.row(v).isZero(0));
    }
  }
  EXPECT_GE(moves.col(2).maxCoeff(), 0.1);
  EXPECT_LE(moves.rowwise().norm().maxCoeff(), 0.3);
}

TEST(FinalFix, SeveralRoundsPartTwoMuscles) {
  LoneBody a(Icosphere(10, 3), true);
  LoneBody b(MovedBy(Icosphere(10, 3), {0, 1, 19.5}), true);
  ASSERT_FALSE(a.body.Inside(b.body.points()).empty());
  int rounds = 0;
  while (rounds < 10 && PushOut({}, &a.body, &b.body)) ++rounds;
  EXPECT_LT(rounds, 10);
  EXPECT_TRUE(a.body.Inside(b.body.points()).empty());
  EXPECT_TRUE(b.body.Inside(a.body.points()).empty());
}

}  // namespace musclewarp
