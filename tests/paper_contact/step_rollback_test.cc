// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/step_rollback.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "paper_contact/lone_body.h"

namespace musclewarp {
namespace {

PaperContactOptions RollbackOptions() {
  PaperContactOptions options;
  options.clearance = 0.001;
  return options;
}

std::vector<char> NoneOf(const LoneBody& body) {
  return std::vector<char>(body.shape.rest.rows(), 0);
}

// A box steps up by (0.1, 0, 0.5) and comes 0.3 into the one above.
const Eigen::RowVector3d kStep(0.1, 0, 0.5);
TriangleSoup BoxAbove() { return UpperBox(4.2); }

}  // namespace

TEST(StepRollback, GoesBackAlongTheStepToAnObstacle) {
  LoneBody muscle(LowerBox(), true);
  LoneBody bone(BoxAbove(), false);
  const Points before = muscle.shape.rest;
  const Points stepped = before.rowwise() + kStep;
  const std::vector<int> inside = bone.body.Inside(stepped);
  ASSERT_GT(inside.size(), 10u);
  muscle.body.MoveTo(stepped);
  std::vector<char> found = NoneOf(muscle);
  RollBackStep(
      RollbackOptions(), before, {}, &muscle.body, &bone.body, &found, nullptr);
  size_t next = 0;
  for (int v = 0; v < before.rows(); ++v) {
    const bool was_inside = next < inside.size() && inside[next] == v;
    next += was_inside;
    EXPECT_EQ(found[v] != 0, was_inside);
    const Eigen::RowVector3d p = muscle.body.points().row(v);
    if (!was_inside) {
      EXPECT_EQ(p, stepped.row(v));
      continue;
    }
    // On the bone's lower side but for the clearance, and on the step's line.
    EXPECT_NEAR(
        p.z(), 4.2 - 0.001 * kStep.normalized().z(), kCoordinateRounding);
    EXPECT_NEAR(
        (p - before.row(v)).cross(kStep).norm(), 0, kCoordinateRounding);
  }
  EXPECT_TRUE(bone.body.Inside(muscle.body.points()).empty());
}

TEST(StepRollback, MusclesGoBackBySixTenths) {
  LoneBody a(LowerBox(), true);
  LoneBody b(BoxAbove(), true);
  const Points before_a = a.shape.rest;
  const Points before_b = b.shape.rest;
  a.body.MoveTo(before_a.rowwise() + kStep);
  std::vector<char> found_a = NoneOf(a);
  std::vector<char> found_b = NoneOf(b);
  RollBackStep(RollbackOptions(),
               before_a,
               before_b,
               &a.body,
               &b.body,
               &found_a,
               &found_b);
  int found = 0;
  for (Eigen::Index v = 0; v < before_a.rows(); ++v) {
    if (!found_a[v]) continue;
    ++found;
    EXPECT_NEAR(a.body.points()(v, 2),
                4.5 - 0.6 * 0.3 - 0.001 * kStep.normalized().z(),
                kCoordinateRounding);
  }
  EXPECT_GT(found, 10);
  // b has not stepped: its vertices inside have no way to go, but are found.
  EXPECT_EQ(b.body.points(), before_b);
  EXPECT_GT(std::count(found_b.begin(), found_b.end(), 1), 10);
}

TEST(StepRollback, WhatHasNoWayOutGoesWhereItWas) {
  // Deep inside before the step already.
  LoneBody muscle(MovedBy(LatticeBox(1, 1, 1), {3, 3, 3}), true);
  LoneBody bone(LatticeBox(8, 8, 8), false);
  const Points before = muscle.shape.rest;
  muscle.body.MoveTo(before.rowwise() + Eigen::RowVector3d(0.1, 0, 0));
  std::vector<char> found = NoneOf(muscle);
  RollBackStep(
      RollbackOptions(), before, {}, &muscle.body, &bone.body, &found, nullptr);
  EXPECT_EQ(muscle.body.points(), before);
  EXPECT_EQ(std::count(found.begin(), found.end(), 1), 8);
}

TEST(StepRollback, WithoutAStepNothingMoves) {
  LoneBody muscle(MovedBy(LowerBox(), kStep), true);
  LoneBody bone(BoxAbove(), false);
  std::vector<char> found = NoneOf(muscle);
  RollBackStep(RollbackOptions(),
               muscle.shape.rest,
               {},
               &muscle.body,
               &bone.body,
               &found,
               nullptr);
  EXPECT_EQ(muscle.body.points(), muscle.shape.rest);
  EXPECT_GT(std::count(found.begin(), found.end(), 1), 10);
}

}  // namespace musclewarp
