// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/convergence_study.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

const Discretisation kAsSet = {200, 10, 1};

// A result of one frame and one muscle, all of which has moved by `move` mm,
// and whose only moment arm is `arm`.
DiscretisationResult ResultWith(const Discretisation& discretisation,
                                double move,
                                double arm) {
  DiscretisedMuscle muscle;
  muscle.displacements = Points::Zero(4, 3);
  muscle.displacements.col(1).setConstant(move);
  muscle.moment_arms["line"] = {{"hip_flexion", arm}};
  DiscretisationResult result;
  result.discretisation = discretisation;
  result.frames.resize(1);
  result.frames[0].muscles = {muscle};
  return result;
}

const StudiedFrames kStudied = {{7}, {"flexed"}, {"psoas"}};

}  // namespace

TEST(ConvergenceStudy, StudiesRunFromTheCoarsestAndHaveWhatIsSet) {
  StudyValues values;
  values.vertices = {600, 100, 600};
  values.spacings = {5, 40};
  values.densities = {};
  const auto studies = StudiesOf(values, kAsSet);
  ASSERT_EQ(studies.size(), 2u);
  const std::vector<Discretisation> hulls = {
      {100, 10, 1}, {200, 10, 1}, {600, 10, 1}};
  EXPECT_EQ(studies[0].discretisations, hulls);
  const std::vector<Discretisation> spacings = {
      {200, 40, 1}, {200, 10, 1}, {200, 5, 1}};
  EXPECT_EQ(studies[1].discretisations, spacings);
  // What is set is solved once.
  const auto all = AllDiscretisations(studies, kAsSet);
  EXPECT_EQ(all.size(), 5u);
  EXPECT_EQ(all[0], kAsSet);
}

TEST(ConvergenceStudy, OneValueIsAtNoDistanceFromItself) {
  StudyValues values;
  values.vertices = {200};
  values.spacings = {};
  values.densities = {};
  const auto studies = StudiesOf(values, kAsSet);
  ASSERT_EQ(studies.size(), 1u);
  const auto rows =
      RowsOf(studies[0], {ResultWith(kAsSet, 3, 20)}, kAsSet, kStudied);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_TRUE(rows[0].is_as_set);
  EXPECT_TRUE(rows[0].is_finest);
  EXPECT_EQ(rows[0].frame, 7);
  EXPECT_EQ(rows[0].muscle, "psoas");
  EXPECT_EQ(rows[0].largest_distance, 0);
  EXPECT_EQ(rows[0].mean_distance, 0);
  EXPECT_EQ(rows[0].moment_arm_difference, 0);
}

TEST(ConvergenceStudy, ComparesWithTheFinestThatWasSolved) {
  const Discretisation fine = {600, 10, 1}, finest = {1200, 10, 1};
  const ConvergenceStudy study = {StudyKind::kVertices, {kAsSet, fine, finest}};
  DiscretisationResult failed;
  failed.discretisation = finest;
  failed.failure = "no room";
  const auto rows =
      RowsOf(study,
             {ResultWith(kAsSet, 3, 20), ResultWith(fine, 5, 19.5), failed},
             kAsSet,
             kStudied);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].largest_distance, 2);
  EXPECT_EQ(rows[0].mean_distance, 2);
  EXPECT_EQ(rows[0].moment_arm_difference, 0.5);
  EXPECT_TRUE(rows[1].is_finest);
  EXPECT_EQ(rows[1].largest_distance, 0);
  EXPECT_EQ(rows[2].failure, "no room");
  EXPECT_EQ(rows[2].value, 1200);
  EXPECT_FALSE(rows[2].is_finest);
}

}  // namespace musclewarp
