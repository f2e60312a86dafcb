// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/group_contact.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/invalid_options.h"
#include "support/meshes.h"
#include "support/muscle_groups.h"

namespace musclewarp {

TEST(GroupContact, HoldsTheVerticesThatItFound) {
  TouchingSpindles scene(ContactLevel::kCoarse);
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  contact.Start(&states);
  const std::vector<MuscleState> before = states;
  states[0].coarse.rowwise() += Eigen::RowVector3d(1, 0, 0);
  contact.AfterStep(0.5, &states);
  const HeldVertices& held = states[0].corrections.held_coarse;
  EXPECT_EQ(static_cast<int>(held.vertices.size()), contact.found_inside(0));
  ASSERT_FALSE(held.IsEmpty());
  for (size_t k = 0; k < held.vertices.size(); ++k) {
    EXPECT_EQ(held.positions.row(k), states[0].coarse.row(held.vertices[k]));
  }
  // A masked vertex has no row in J_g.
  const FineVolume volume = EvaluateFineVolume(
      scene.models[0], states[0].coarse, states[0].corrections);
  for (const int v : held.vertices) {
    EXPECT_TRUE(volume.gradient.row(v).isZero(0));
  }
  EXPECT_GT(volume.gradient.norm(), 0);
}

TEST(GroupContact, ForgetsAfterMaskMemory) {
  TouchingSpindles scene(ContactLevel::kCoarse);
  scene.options.mask_memory = 2;
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  contact.Start(&states);
  states[0].coarse.rowwise() += Eigen::RowVector3d(1, 0, 0);
  contact.AfterStep(0.5, &states);
  EXPECT_FALSE(states[0].corrections.held_coarse.IsEmpty());
  states[0].coarse.rowwise() -= Eigen::RowVector3d(40, 0, 0);
  contact.AfterStep(0.5, &states);
  EXPECT_FALSE(states[0].corrections.held_coarse.IsEmpty());
  contact.AfterStep(0.5, &states);
  EXPECT_TRUE(states[0].corrections.held_coarse.IsEmpty());
}

TEST(GroupContact, FineOffsetsDieAwayWhereNothingIsTouched) {
  TouchingSpindles scene(ContactLevel::kFine);
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  contact.Start(&states);
  states[0].coarse.rowwise() -= Eigen::RowVector3d(40, 0, 0);
  const Points offset = RandomPoints(scene.models[0].fine_rest.rows(), 1);
  states[0].corrections.fine_offset = offset;
  contact.AfterStep(0.25, &states);
  EXPECT_EQ(contact.found_inside(0), 0);
  // Adding and taking away coordinates of size 100.
  EXPECT_LT((states[0].corrections.fine_offset - 0.75 * offset).norm(), 1e-12);
}

TEST(GroupContact, FinishLeavesNothingInsideAndKeepsTheVolume) {
  TouchingSpindles scene(ContactLevel::kFine);
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  ASSERT_GT(scene.VerticesInside(states), 0);
  EXPECT_TRUE(contact.Finish(&states));
  EXPECT_EQ(scene.VerticesInside(states), 0);
  for (size_t i = 0; i < states.size(); ++i) {
    EXPECT_NEAR(scene.VolumeRatio(i, states[i]), 1, 1e-9);
  }
}

// Muscles that follow on from a pose in which they were apart go back along the
// way they came, and nowhere else.
TEST(GroupContact, FollowsOnFromThePoseBefore) {
  TouchingSpindles scene(ContactLevel::kFine, /*gap=*/2);
  GroupContact contact = scene.Contact();
  std::vector<MuscleState> states = scene.RestStates();
  const std::vector<MuscleState> before = states;
  // The first muscle goes 7 mm towards the second, 5 mm into it.
  states[0].coarse.col(0).array() += 7;
  contact.FollowOn(before, {Eigen::Matrix4d::Identity()});
  EXPECT_TRUE(contact.Start(&states));
  EXPECT_GT(contact.found_inside(0), 0);
  const Points moved = FinePoints(scene.models[0], states[0]);
  const Points stepped = FinePoints(scene.models[0], {states[0].coarse, {}});
  double farthest = 0;
  for (Eigen::Index v = 0; v < moved.rows(); ++v) {
    const Eigen::RowVector3d back = moved.row(v) - stepped.row(v);
    EXPECT_LE(back[0], 1e-12);
    EXPECT_LT(back.tail<2>().norm(), 1e-9);
    farthest = std::max(farthest, -back[0]);
  }
  // 0.6 of 5 mm, the deepest.
  EXPECT_NEAR(farthest, 3, 0.2);
}

TEST(GroupContactOptions, DefaultsAreValid) {
  ExpectValid(GroupContactOptions());
}

TEST(GroupContactOptions, RefuseValuesOutOfRange) {
  ExpectRefused<GroupContactOptions>(
      [](auto* options) { options->mask_memory = 0; },
      "GroupContactOptions::mask_memory is 0, allowed: above 0");
  ExpectRefused<GroupContactOptions>(
      [](auto* options) { options->max_final_rounds = -1; },
      "GroupContactOptions::max_final_rounds is -1, allowed: 0 or above");
  ExpectRefused<GroupContactOptions>(
      [](auto* options) { options->paper.clearance = -1; },
      "PaperContactOptions::clearance is -1, allowed: 0 or above");
}

}  // namespace musclewarp
