// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/plane_set.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "certified_contact/contact_group.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Eigen::RowVector3i;

// What a projection may leave (geometry/half_space_projection.h).
constexpr double kProjection = 1e-8;

// A muscle whose vertex 0 is at (0, 0, 10), and one below it, at rest.
struct TwoSpheres {
  ContactGroup group{{SphereAt({0, 0, 0}, 10, 1), SphereAt({0, 0, -30}, 10, 1)},
                     {}};
  ContactStep step =
      MakeContactStep(group.scene, group.state, group.state.targets, {});
  StepOptions options;

  SeparatingPlane PlaneOverVertex(int v,
                                  const RowVector3d& normal,
                                  double above) const {
    SeparatingPlane plane;
    plane.muscle_above = 0;
    plane.above = RowVector3i::Constant(v);
    plane.normal = normal;
    plane.level = normal.dot(step.predicted[0].row(v)) + above;
    return plane;
  }
  RowVector3d Place(int v) const { return step.predicted[0].row(v); }
};

TEST(PlaneSet, LeavesAPointWithoutPlanesWhereItIs) {
  TwoSpheres spheres;
  PlaneSet planes(spheres.options, spheres.step);
  const RowVector3d p = spheres.Place(3) + RowVector3d(0.1, 0.2, 0.3);
  planes.FindNear(0, 3, p);
  EXPECT_EQ(planes.Projected(0, 3, p), p);
  EXPECT_EQ(planes.WorstViolation(spheres.step.predicted), 0);
}

TEST(PlaneSet, ProjectsIntoAllHalfSpacesHoweverManyThereAre) {
  TwoSpheres spheres;
  PlaneSet planes(spheres.options, spheres.step);
  // A cone of 2000 planes around the z axis: their common part begins 0.4 above
  // the vertex. One of them alone, the last of all, asks for more.
  std::vector<SeparatingPlane> cone;
  for (int i = 0; i < 2000; ++i) {
    const double angle = 0.01 * i;
    const RowVector3d normal =
        RowVector3d(0.1 * std::cos(angle), 0.1 * std::sin(angle), 1)
            .normalized();
    SeparatingPlane plane = spheres.PlaneOverVertex(0, normal, 0.4);
    plane.distance = 0.1;
    cone.push_back(plane);
  }
  SeparatingPlane highest =
      spheres.PlaneOverVertex(0, RowVector3d(0, 0, 1), 0.8);
  cone.push_back(highest);
  planes.Add(cone);
  const RowVector3d start = spheres.Place(0);
  planes.FindNear(0, 0, start);
  const RowVector3d projected = planes.Projected(0, 0, start);
  for (const SeparatingPlane& plane : cone) {
    EXPECT_GE(plane.normal.dot(projected), plane.level - kProjection);
  }
  EXPECT_NEAR(projected[2], start[2] + 0.8, kProjection);
}

TEST(PlaneSet, ABoneHasTheLastWordWhereThereIsNoRoom) {
  TwoSpheres spheres;
  PlaneSet planes(spheres.options, spheres.step);
  // A bone asks for up, a muscle that moves with nothing for down.
  SeparatingPlane muscle;
  muscle.muscle_above = 1;
  muscle.muscle_below = 0;
  muscle.above = RowVector3i::Constant(0);
  muscle.below = RowVector3i::Constant(0);
  muscle.normal = RowVector3d(0, 0, 1);
  muscle.distance = 0.1;
  const SeparatingPlane bone =
      spheres.PlaneOverVertex(0, RowVector3d(0, 0, 1), 0.3);
  planes.Add({bone, muscle});
  planes.UpdateLevels(spheres.step.predicted, spheres.step.predicted, true);
  const RowVector3d start = spheres.Place(0);
  planes.FindNear(0, 0, start);
  EXPECT_GE(planes.Projected(0, 0, start)[2], start[2] + 0.3 - 1e-3);
}

TEST(PlaneSet, PushesNoFartherThanAllowed) {
  TwoSpheres spheres;
  spheres.options.relaxation.max_push = 2;
  PlaneSet planes(spheres.options, spheres.step);
  planes.Add({spheres.PlaneOverVertex(0, RowVector3d(0, 0, 1), 40)});
  const RowVector3d start = spheres.Place(0);
  planes.FindNear(0, 0, start);
  EXPECT_NEAR((planes.Projected(0, 0, start) - start).norm(), 2, 1e-12);
}

TEST(PlaneSet, PutsAPlaneHalfWayBetweenWhereTwoMusclesWantToGo) {
  TwoSpheres spheres;
  PlaneSet planes(spheres.options, spheres.step);
  SeparatingPlane plane;
  plane.muscle_above = 0;
  plane.muscle_below = 1;
  plane.above = spheres.group.soups[0].triangles.row(0);
  plane.below = spheres.group.soups[1].triangles.row(0);
  plane.normal = RowVector3d(0, 0, 1);
  plane.half_gap = 0.05;
  planes.Add({plane});
  std::vector<Points> wanted = spheres.step.predicted;
  // Triangle 0 of the lower muscle wants to go where that of the upper one is.
  wanted[1].col(2).array() += 30;
  planes.UpdateLevels(wanted, wanted, true);
  double lowest = 1e300, highest = -1e300;
  for (int k = 0; k < 3; ++k) {
    lowest = std::min(lowest, wanted[0](plane.above[k], 2));
    highest = std::max(highest, wanted[1](plane.below[k], 2));
  }
  const double middle = (lowest + highest) / 2;
  // Either side keeps half of the gap.
  for (int k = 0; k < 3; ++k) {
    for (const int muscle : {0, 1}) {
      const int v = muscle == 0 ? plane.above[k] : plane.below[k];
      const RowVector3d p = wanted[muscle].row(v);
      planes.FindNear(muscle, v, p);
      const RowVector3d q = planes.Projected(muscle, v, p);
      const double beyond = muscle == 0 ? q[2] - middle : middle - q[2];
      EXPECT_GE(beyond, 0.05 - kProjection);
    }
  }
}

// A tighter plane of a muscle must not stand in for that of a bone: it yields
// where there is no room.
TEST(PlaneSet, ABoneHasTheLastWordBehindAMuscleThatFacesTheSameWay) {
  TwoSpheres spheres;
  PlaneSet planes(spheres.options, spheres.step);
  const RowVector3d up(0, 0, 1);
  SeparatingPlane up_for_a_muscle;
  up_for_a_muscle.muscle_above = 0;
  up_for_a_muscle.muscle_below = 1;
  up_for_a_muscle.above = RowVector3i::Constant(0);
  up_for_a_muscle.below = RowVector3i::Constant(0);
  up_for_a_muscle.normal = up;
  SeparatingPlane down_for_a_muscle = up_for_a_muscle;
  down_for_a_muscle.below = RowVector3i::Constant(1);
  down_for_a_muscle.normal = -up;
  planes.Add({spheres.PlaneOverVertex(0, up, 0.3),
              up_for_a_muscle,
              down_for_a_muscle});
  // One vertex of the other muscle wants the plane 0.5 above, another one wants
  // its plane 0.3 below: between both there is no room.
  const RowVector3d start = spheres.Place(0);
  std::vector<Points> wanted = spheres.step.predicted;
  wanted[1].row(0) = start + up;
  wanted[1].row(1) = start - 0.6 * up;
  planes.UpdateLevels(wanted, wanted, true);
  planes.FindNear(0, 0, start);
  EXPECT_GE(planes.Projected(0, 0, start)[2], start[2] + 0.3 - 1e-3);
}

TEST(PlaneSet, HoldsWhatElseIsBelowAPlane) {
  TwoSpheres spheres;
  spheres.options.relaxation.max_push = 100;
  PlaneSet planes(spheres.options, spheres.step);
  SeparatingPlane plane;
  plane.muscle_above = 0;
  plane.muscle_below = 1;
  plane.above = RowVector3i::Constant(0);
  plane.below = RowVector3i::Constant(0);
  plane.also_below = {7};
  plane.normal = RowVector3d(0, 0, 1);
  planes.Add({plane});
  std::vector<Points> wanted = spheres.step.predicted;
  wanted[0].row(0) << 0, 0, 0;
  wanted[1].row(0) << 0, 0, 0;
  wanted[1].row(7) << 1, 0, 0.4;
  planes.UpdateLevels(wanted, wanted, true);
  // The plane is half way to the highest of both.
  const RowVector3d high = wanted[1].row(7);
  planes.FindNear(1, 7, high);
  EXPECT_NEAR(planes.Projected(1, 7, high)[2], 0.2, kProjection);
  planes.FindNear(0, 0, wanted[0].row(0));
  EXPECT_NEAR(planes.Projected(0, 0, wanted[0].row(0))[2], 0.2, kProjection);
}

// Of two planes that face almost the same way the tighter one counts, whichever
// comes first.
TEST(PlaneSet, LooksOnlyAtTheTightestOfPlanesThatFaceTheSameWay) {
  const RowVector3d up(0, 0, 1);
  const RowVector3d leaning = RowVector3d(0.05, 0, 1).normalized();
  for (const double first : {0.3, 0.1}) {
    TwoSpheres spheres;
    PlaneSet planes(spheres.options, spheres.step);
    planes.Add({spheres.PlaneOverVertex(0, leaning, first),
                spheres.PlaneOverVertex(0, up, 0.4 - first)});
    const RowVector3d start = spheres.Place(0);
    planes.FindNear(0, 0, start);
    const RowVector3d expected = start + 0.3 * (first > 0.2 ? leaning : up);
    EXPECT_LT((planes.Projected(0, 0, start) - expected).norm(), kProjection);
  }
}

TEST(PlaneSet, OfTwoMusclesTheAttachedOneStaysAndTheOtherGivesWay) {
  for (const int attached : {0, 1}) {
    TwoSpheres spheres;
    spheres.options.relaxation.max_push = 100;
    SeparatingPlane plane;
    plane.muscle_above = 0;
    plane.muscle_below = 1;
    plane.above = RowVector3i::Constant(0);
    plane.below = RowVector3i::Constant(0);
    plane.normal = RowVector3d(0, 0, 1);
    plane.half_gap = 0.05;
    spheres.step.attached[attached].vertices = {0};
    PlaneSet planes(spheres.options, spheres.step);
    planes.Add({plane});
    // Both want to go 0.4 beyond the other.
    std::vector<Points> wanted = spheres.step.predicted;
    wanted[0].row(0) << 0, 0, 0;
    wanted[1].row(0) << 0, 0, 0.4;
    planes.UpdateLevels(wanted, wanted, true);
    for (const int muscle : {0, 1}) {
      const RowVector3d p = wanted[muscle].row(0);
      planes.FindNear(muscle, 0, p);
      const double moved = (planes.Projected(muscle, 0, p) - p).norm();
      // The other one gives way by what both lack, and the gap.
      EXPECT_NEAR(moved, muscle == attached ? 0 : 0.5, kProjection);
    }
  }
}

TEST(PlaneSet, ShiftsAPlaneToTheSideThatCannotMove) {
  TwoSpheres spheres;
  PlaneSet planes(spheres.options, spheres.step);
  SeparatingPlane plane;
  plane.muscle_above = 0;
  plane.muscle_below = 1;
  plane.above = RowVector3i::Constant(0);
  plane.below = RowVector3i::Constant(0);
  plane.normal = RowVector3d(0, 0, 1);
  planes.Add({plane});
  std::vector<Points> wanted = spheres.step.predicted;
  wanted[0].row(0) << 0, 0, 0;
  wanted[1].row(0) << 0, 0, 0.4;
  planes.UpdateLevels(wanted, wanted, true);
  // The upper one is held at 0 where the plane, at 0.2, wanted it above. The
  // plane goes to it. The lower one is where it was asked to be.
  std::vector<Points> reached = wanted;
  reached[1](0, 2) = 0.2;
  planes.UpdateLevels(wanted, reached, false);
  EXPECT_NEAR(planes.WorstViolation(reached), 0.2, 1e-12);
  reached[1](0, 2) = 0;
  EXPECT_NEAR(planes.WorstViolation(reached), 0, 1e-12);
}

TEST(PlaneSet, AShiftThatNobodyNeedsAnyMoreFades) {
  constexpr double kSums = 1e-12;  // of a few numbers of size 1
  TwoSpheres spheres;
  PlaneSet planes(spheres.options, spheres.step);
  SeparatingPlane plane;
  plane.muscle_above = 0;
  plane.muscle_below = 1;
  plane.above = RowVector3i::Constant(0);
  plane.below = RowVector3i::Constant(0);
  plane.normal = RowVector3d(0, 0, 1);
  planes.Add({plane});
  std::vector<Points> wanted = spheres.step.predicted;
  wanted[0].row(0) << 0, 0, 0;
  wanted[1].row(0) << 0, 0, 0.4;
  planes.UpdateLevels(wanted, wanted, true);
  // Held back by 0.3, the upper one has the plane shifted down to it.
  std::vector<Points> held = wanted;
  held[0](0, 2) = -0.1;
  held[1](0, 2) = -0.1;
  planes.UpdateLevels(wanted, held, false);
  EXPECT_NEAR(planes.WorstViolation(held), 0, kSums);
  // Then both are free and far on their sides of it: it goes back to half way
  // between where they want to go, by the same share each time.
  std::vector<Points> free = wanted;
  free[0](0, 2) = 1;
  free[1](0, 2) = -1;
  std::vector<Points> at_zero = free;
  at_zero[0](0, 2) = 0;
  double shift = 0.3;
  for (int sweep = 0; sweep < 200; ++sweep) {
    planes.UpdateLevels(wanted, free, false);
    shift *= spheres.options.relaxation.room_decay;
    if (shift > 0.2) continue;
    EXPECT_NEAR(planes.WorstViolation(at_zero), 0.2 - shift, kSums);
  }
  // 0.97^200 is 0.002.
  constexpr double kLeft = 1e-3;
  EXPECT_NEAR(planes.WorstViolation(at_zero), 0.2, kLeft);
}

TEST(PlaneSet, NamesThePlaneThatATargetViolatesMost) {
  TwoSpheres spheres;
  PlaneSet planes(spheres.options, spheres.step);
  SeparatingPlane most_violated =
      spheres.PlaneOverVertex(0, RowVector3d(0, 1, 0), 0.3);
  most_violated.bone = 2;
  planes.Add({spheres.PlaneOverVertex(0, RowVector3d(0, 0, 1), 0.1),
              most_violated,
              spheres.PlaneOverVertex(1, RowVector3d(1, 0, 0), -3)});
  const Points& points = spheres.step.predicted[0];
  const auto most = planes.MostViolated(0, {0, 1, 2}, points, points);
  // Vertex 1 is farther than contact_distance from its plane, 2 has none.
  ASSERT_EQ(most.spaces.size(), 1u);
  EXPECT_EQ(most.spaces[0].vertex, 0);
  EXPECT_EQ(most.spaces[0].space.normal, RowVector3d(0, 1, 0));
  ASSERT_EQ(most.owners.size(), 1u);
  EXPECT_EQ(most.owners[0].bone, 2);
}

}  // namespace
}  // namespace musclewarp
