// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/step.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
#include <string>

#include "certified_contact/contact_group.h"
#include "musclewarp/mesh/transformed.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using Eigen::RowVector3d;

Matrix4d Shift(const Eigen::Vector3d& by) {
  Matrix4d shift = Matrix4d::Identity();
  shift.topRightCorner<3, 1>() = by;
  return shift;
}

Matrix4d TurnAboutZ(double angle) {
  Matrix4d turn = Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return turn;
}

}  // namespace

// Once the coarse meshes have moved out of the way of the planes, next to
// nothing is left for single vertices.
TEST(Step, ShowsTheCoarseMeshesThePlanesToMakeWayFor) {
  ContactGroup group = SpheresOverABone();
  std::vector<Points> free = group.state.targets;
  free[0].rowwise() += RowVector3d(0, 0, -0.8);
  std::vector<int> all(free[0].rows());
  std::iota(all.begin(), all.end(), 0);
  double deepest = 0;
  std::vector<Points> solved = free;
  const auto make_way = [&](const PlaneSet& planes,
                            const std::vector<Points>& points) {
    for (const VertexHalfSpace& plane :
         planes.MostViolated(0, all, points[0], free[0]).spaces) {
      const RowVector3d& normal = plane.space.normal;
      EXPECT_NEAR(normal.norm(), 1, 1e-12);
      const double depth =
          plane.space.level - normal.dot(free[0].row(plane.vertex));
      if (depth <= deepest) continue;
      deepest = depth;
      // The bone is below, its upper side at 0, the muscle was at 0.5.
      EXPECT_NEAR(normal[2], 1, 1e-6);
      EXPECT_GT(plane.space.level, 0);
      EXPECT_LT(plane.space.level, 0.5);
    }
    solved[0].col(2).array() += deepest;
    return CoarseSolution{{}, solved, {}};
  };
  StepGoal goal = {group.state};
  goal.state.targets = free;
  StepOptions options;
  options.relaxation.smoothing_length = 4;
  options.sweeps = 1000;  // until nothing changes
  const StepResult result =
      Step(options, group.scene, group.state, goal, make_way);
  EXPECT_GT(deepest, 0.3);
  EXPECT_FALSE(result.summary.defects.HasCrossings());
  group.state = result.state;
  EXPECT_EQ(group.CrossingPairs(), 0);
  EXPECT_EQ(group.state.targets[0], solved[0]);
  // Next to nothing is left for single vertices: other planes than the deepest
  // may ask for a little more.
  const Points offset = group.state.points[0] - solved[0];
  EXPECT_LT(offset.rowwise().norm().maxCoeff(), 1e-3);
}

TEST(Step, IsGivenUpIfItPushesMusclesTooFar) {
  const ContactGroup group = SpheresOverABone();
  StepGoal goal = {group.state};
  goal.state.targets[0].col(2).array() -= 1.2;  // 0.7 into the bone
  const StepOptions options;
  const StepSummary taken =
      Step(options, group.scene, group.state, goal).summary;
  EXPECT_FALSE(taken.is_given_up);
  EXPECT_GT(taken.push, 0);
  // Half of the sweeps show whether the push is too large.
  const auto stay = [&](const PlaneSet&, const std::vector<Points>&) {
    return CoarseSolution{{}, goal.state.targets, {}};
  };
  goal.max_push = taken.push / 4;
  const StepResult given_up =
      Step(options, group.scene, group.state, goal, stay);
  EXPECT_TRUE(given_up.summary.is_given_up);
  EXPECT_FALSE(given_up.summary.passes_bone);
  EXPECT_GT(given_up.summary.push, goal.max_push);
  EXPECT_TRUE(given_up.state.points.empty());
  goal.max_push = 4 * taken.push;
  EXPECT_FALSE(
      Step(options, group.scene, group.state, goal, stay).summary.is_given_up);
}

// The depth of the passage says nothing of how long a step may be.
TEST(Step, IsGivenUpIfAMusclePassesThroughABone) {
  const ContactGroup group = SpheresOverABone();
  StepGoal goal = {group.state};
  const double deep = StepOptions().relaxation.max_push + 2;
  goal.state.targets[0].col(2).array() -= deep;
  goal.max_push = 100;
  const StepSummary summary =
      Step(StepOptions(), group.scene, group.state, goal).summary;
  EXPECT_TRUE(summary.is_given_up);
  EXPECT_TRUE(summary.passes_bone);
}

TEST(Step, TellsWhetherMusclesArePushedByAllTheyMayBe) {
  const ContactGroup group = SpheresOverABone();
  StepGoal goal = {group.state};
  StepOptions options;
  options.sweeps = 100;
  EXPECT_TRUE(
      Step(options, group.scene, group.state, goal).summary.is_short_of_reach);
  // Both spheres are to go by more than the reach beside their targets.
  ContactState aside = group.state;
  for (Points& points : aside.points) points.col(1).array() += 3;
  EXPECT_FALSE(
      Step(options, group.scene, aside, goal).summary.is_short_of_reach);
}

TEST(Step, GoesToTheTargetsWhereNothingIsInTheWay) {
  ContactGroup group = SpheresOverABone();
  ContactState next = group.state;
  next.targets[0].rowwise() += RowVector3d(-0.3, 0.2, 0.4);
  const StepSummary summary = group.StepTo(next);
  EXPECT_FALSE(summary.defects.HasCrossings());
  EXPECT_EQ(summary.rounds, 1);
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT((group.state.points[i] - next.targets[i]).norm(), 1e-11);
  }
}

TEST(Step, RigidMotionStaysRigid) {
  // Pressed to the bone first, then everything turns.
  ContactGroup group = SpheresOverABone();
  ContactState pressed = group.state;
  pressed.targets[0].col(2).array() -= 0.8;
  for (int i = 0; i < 40; ++i) {
    ASSERT_FALSE(group.StepTo(pressed).defects.HasCrossings());
  }
  const ContactState before = group.state;
  const Matrix4d turn = TurnAboutZ(0.02);
  ContactState next = before;
  for (int i = 0; i < 2; ++i) {
    next.targets[i] = Transformed(before.targets[i], turn);
  }
  next.bones_from_rest[0] = turn;
  ASSERT_FALSE(group.StepTo(next).defects.HasCrossings());
  for (int i = 0; i < 2; ++i) {
    // The offsets are some tenths of a mm and go on to settle.
    EXPECT_LT((group.state.points[i] - Transformed(before.points[i], turn))
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              0.02);
  }
}

TEST(Step, KeepsVolumeAndDistanceUnderPressure) {
  ContactGroup group = SpheresOverABone();
  for (int step = 1; step <= 10; ++step) {
    // Into the bone and into each other.
    ContactState next = group.state;
    next.targets[0] = group.soups[0].points.rowwise() +
                      RowVector3d(0.1 * step, 0, -0.3 * step);
    next.targets[1] = group.soups[1].points.rowwise() +
                      RowVector3d(-0.1 * step, 0, -0.1 * step);
    const StepSummary summary = group.StepTo(next);
    ASSERT_FALSE(summary.defects.HasCrossings()) << step;
    EXPECT_EQ(summary.defects.is_gap_violated,
              summary.violation > StepOptions().AllowedViolation());
    EXPECT_EQ(group.CrossingPairs(), 0);
    for (int i = 0; i < 2; ++i) {
      EXPECT_GT(group.state.points[i].col(2).minCoeff(), 0);
      // VolumeOptions::tolerance.
      EXPECT_NEAR(group.VolumeError(i), 0, 2e-8);
    }
  }
  // Contact is worth no more than what would overlap, by far.
  const Points moves = group.state.points[0] - group.state.targets[0];
  EXPECT_LT(moves.rowwise().norm().maxCoeff(), 3.5);
  EXPECT_GT(moves.rowwise().norm().maxCoeff(), 2);
}

TEST(Step, GoesBackWhenNothingPressesAnyMore) {
  ContactGroup group = SpheresOverABone();
  for (const double down : {0.5, 1.0, 0.5, 0.0}) {
    ContactState next = group.state;
    next.targets[0] =
        group.soups[0].points.rowwise() + RowVector3d(0, 0, -down);
    ASSERT_FALSE(group.StepTo(next).defects.HasCrossings());
  }
  for (int i = 0; i < 60; ++i) {
    ContactState next = group.state;
    ASSERT_FALSE(group.StepTo(next).defects.HasCrossings());
  }
  EXPECT_LT((group.state.points[0] - group.soups[0].points)
                .rowwise()
                .norm()
                .maxCoeff(),
            1e-3);
}

TEST(Step, ABoneDoesNotPassThroughAMuscle) {
  // A thin plate comes from the side by far more than its thickness.
  ContactGroup group({SphereAt({0, 0, 0}, 10, 3)},
                     {MovedBy(Box(0.2, 60, 60), {-10.4, 0, 0})});
  for (int step = 1; step <= 12; ++step) {
    ContactState next = group.state;
    next.bones_from_rest[0] = Shift({0.5 * step, 0, 0});
    ASSERT_FALSE(group.StepTo(next).defects.HasCrossings()) << step;
    EXPECT_EQ(group.CrossingPairs(), 0);
    EXPECT_GT(group.state.points[0].col(0).minCoeff(), -10.3 + 0.5 * step);
  }
}

TEST(Step, SaysSoWhereThereIsNoRoom) {
  // Two plates that close to nothing.
  ContactGroup group({SphereAt({0, 0, 0}, 10, 2)},
                     {MovedBy(Box(60, 60, 1), {0, 0, 10.7}),
                      MovedBy(Box(60, 60, 1), {0, 0, -10.7})});
  ContactState next = group.state;
  next.bones_from_rest[0] = Shift({0, 0, -20.6});
  const StepSummary summary = group.StepTo(next);
  EXPECT_TRUE(summary.defects.HasCrossings());
  EXPECT_GT(summary.defects.crossing_pairs, 0);
  EXPECT_EQ(summary.rounds, StepOptions().max_rounds);
}

TEST(Step, DoesNotDependOnTheOrderOfMuscles) {
  const TriangleSoup a = SphereAt({0, 0, 10.5}, 10, 3);
  const TriangleSoup b = SphereAt({20.5, 0, 10.5}, 10, 3);
  const TriangleSoup c = SphereAt({10, 18.5, 10.5}, 10, 4);
  const TriangleSoup bone = MovedBy(Box(80, 80, 5), {10, 10, -2.5});
  ContactGroup one({a, b, c}, {bone});
  ContactGroup two({c, a, b}, {bone});
  ASSERT_EQ(one.CrossingPairs(), 0);
  for (int step = 0; step < 3; ++step) {
    ContactState next_one = one.state, next_two = two.state;
    for (int i = 0; i < 3; ++i) {
      const RowVector3d move(i == 0 ? 0.5 : -0.3, -0.2 * i, -0.4);
      next_one.targets[i].rowwise() += move;
      next_two.targets[(i + 1) % 3].rowwise() += move;
    }
    ASSERT_FALSE(one.StepTo(next_one).defects.HasCrossings());
    ASSERT_FALSE(two.StepTo(next_two).defects.HasCrossings());
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT((one.state.points[i] - two.state.points[(i + 1) % 3])
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              1e-6);
  }
}

// Two spheres want to be where each other is; one stands still, and the other
// stops beside it.
TEST(Step, LeavesMusclesThatStandStillAsTheyAre) {
  ContactGroup group = SpheresOverABone();
  StepGoal goal = {group.state};
  goal.is_still = {false, true};
  goal.state.targets[0].rowwise() += RowVector3d(0.8, 0, 0);
  const StepOptions options;
  const StepResult result = Step(options, group.scene, group.state, goal);
  EXPECT_EQ(result.state.points[1], group.state.points[1]);
  EXPECT_GT((result.state.points[0] - group.state.points[0]).norm(), 1);
  EXPECT_FALSE(result.summary.defects.HasCrossings());
  EXPECT_LT(result.summary.violation, options.AllowedViolation());
  EXPECT_FALSE(result.summary.is_pushed_far[1]);
  group.state = result.state;
  EXPECT_EQ(group.CrossingPairs(), 0);
  EXPECT_LT(group.VolumeError(0), 1e-8);
}

// The cap of a sphere has been pushed in through its other side. Between planes
// that keep its sides apart it stays there.
TEST(Step, UnfoldsACrumpledMuscle) {
  ContactGroup group({Icosphere(10, 3)}, {});
  ContactState crumpled = group.state;
  for (Eigen::Index v = 0; v < crumpled.points[0].rows(); ++v) {
    auto p = crumpled.points[0].row(v);
    if (p[2] > 6) p[2] -= 18;
  }
  const StepGoal goal = {group.state};
  StepOptions options;
  options.reach = 20;
  options.relaxation.max_push = 20;
  options.sweeps = 300;  // until little changes
  options.unfolds = true;
  const StepResult unfolded = Step(options, group.scene, crumpled, goal);
  EXPECT_EQ(unfolded.summary.defects.self_crossing_pairs, 0);
  EXPECT_EQ(unfolded.summary.rounds, 1);
  EXPECT_LT((unfolded.state.points[0] - group.state.points[0])
                .rowwise()
                .norm()
                .maxCoeff(),
            1);
  options.unfolds = false;
  EXPECT_GT(Step(options, group.scene, crumpled, goal)
                .summary.defects.self_crossing_pairs,
            0);
}

TEST(DefectCounts, CrossingsAreWorseThanAGapAndThatIsWorseThanFolds) {
  DefectCounts folded, narrow, self_crossing, crossing;
  folded.folded_triangles = 100;
  narrow.is_gap_violated = true;
  self_crossing.self_crossing_pairs = 1;
  crossing.crossing_pairs = 1;
  for (const DefectCounts& faults : {folded, narrow, self_crossing, crossing}) {
    EXPECT_FALSE(faults.IsEmpty());
    EXPECT_TRUE(IsBetter(DefectCounts(), faults));
    EXPECT_FALSE(IsBetter(faults, faults));
  }
  EXPECT_TRUE(IsBetter(folded, narrow));
  EXPECT_TRUE(IsBetter(narrow, self_crossing));
  EXPECT_TRUE(IsBetter(self_crossing, crossing));
  DefectCounts two = crossing;
  two.self_crossing_pairs = 1;
  EXPECT_TRUE(IsBetter(crossing, two));
}

}  // namespace musclewarp
