// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/studies/convergence_run.h"

#include <gtest/gtest.h>

#include <string>

#include "musclewarp/mesh/measures.h"
#include "support/prepared_small_scene.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

// The small scene, with a pose at rest and one flexed.
class ConvergenceRun : public ::testing::Test {
 protected:
  ConvergenceRun() {
    options_.prepare.muscle.hull.coarse_vertices = 60;
    options_.frames.contact = ContactKind::kNone;
    Scene scene = SmallScene();
    for (SceneBone& bone : scene.bones) bone.body = bone.name;
    scene.poses = {FlexedPose(0), FlexedPose(0.3)};
    base_ = PrepareScene(scene, options_.prepare);
  }

  DiscretisationResult Solve(const Discretisation& discretisation,
                             int frame) const {
    DiscretisationResult result =
        SolveDiscretisation(options_, base_, discretisation, {frame});
    EXPECT_EQ(result.failure, "");
    return result;
  }

  DeformerOptions options_;
  PreparedScene base_;
  const std::vector<Discretisation> all_ = {
      {60, 10, 1}, {120, 10, 1}, {60, 5, 1}, {60, 10, 0.25}, {60, 10, 4}};
};

TEST_F(ConvergenceRun, RestStaysAtRest) {
  // Solvers start at rest, where no row has an error: what is left is rounding.
  for (const Discretisation& discretisation : all_) {
    const DiscretisationResult result = Solve(discretisation, 0);
    for (const DiscretisedMuscle& muscle : result.frames.at(0).muscles) {
      EXPECT_LT(muscle.displacements.cwiseAbs().maxCoeff(), 1e-6);
      EXPECT_NEAR(muscle.stretch.largest, 1, 1e-6);
      EXPECT_NEAR(muscle.volume_ratio, 1, 1e-8);
    }
  }
}

TEST_F(ConvergenceRun, ChangesWhatIsAskedForAndNothingElse) {
  for (const Discretisation& discretisation : all_) {
    const PreparedScene scene =
        Rediscretised(base_, options_.prepare, discretisation);
    for (size_t m = 0; m < scene.muscles.size(); ++m) {
      const MuscleModel& before = base_.muscles[m].model;
      const MuscleModel& after = scene.muscles[m].model;
      const bool has_other_hull = discretisation.coarse_vertices != 60;
      EXPECT_EQ(after.coarse_rest.rows() != before.coarse_rest.rows(),
                has_other_hull);
      if (!has_other_hull) {
        EXPECT_EQ(after.coarse_rest, before.coarse_rest);
      }
      EXPECT_EQ(after.samples.size() > before.samples.size(),
                discretisation.sample_spacing < 10);
      EXPECT_EQ(after.lines.size(), before.lines.size());
      EXPECT_EQ(after.attachments.size(), before.attachments.size());
      EXPECT_NEAR(static_cast<double>(after.fine_triangles.rows()) /
                      static_cast<double>(before.fine_triangles.rows()),
                  discretisation.density,
                  0.01);
    }
  }
}

TEST_F(ConvergenceRun, MovesAreThoseOfTheVerticesOfTheBaseMesh) {
  const DiscretisationResult base = Solve(all_[0], 1);
  const DiscretisationResult dense = Solve(all_[4], 1);
  for (size_t m = 0; m < base_.muscles.size(); ++m) {
    const DiscretisedMuscle& muscle = base.frames[0].muscles[m];
    EXPECT_EQ(muscle.displacements.rows(),
              base_.muscles[m].model.fine_rest.rows());
    EXPECT_LT(muscle.rest_distance, 1e-9);
    EXPECT_GT(muscle.displacements.rowwise().norm().maxCoeff(), 1);
    // The hull is the same, so that only rows of attachments and the volume
    // of a finer surface, which is not quite flat after the move, differ.
    EXPECT_LT((dense.frames[0].muscles[m].displacements - muscle.displacements)
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              0.5);
  }
}

TEST_F(ConvergenceRun, CertifiedContactGoesThroughAllFramesOfAMotion) {
  options_.frames.contact = ContactKind::kCertified;
  options_.prepare.remove_self_crossings = true;
  options_.prepare.remove_slivers = true;
  Scene scene = SmallScene();
  for (SceneBone& bone : scene.bones) bone.body = bone.name;
  scene.poses = {FlexedPose(0), FlexedPose(0.15), FlexedPose(0.3)};
  scene.is_motion = true;
  base_ = PrepareScene(scene, options_.prepare);
  const DiscretisationResult last = Solve(all_[0], 2);
  const DiscretisationResult every =
      SolveDiscretisation(options_, base_, all_[0], {0, 1, 2});
  ASSERT_EQ(last.frames.size(), 1u);
  ASSERT_EQ(every.frames.size(), 3u);
  EXPECT_TRUE(last.frames[0].is_usable);
  for (size_t m = 0; m < base_.muscles.size(); ++m) {
    EXPECT_EQ(last.frames[0].muscles[m].displacements,
              every.frames[2].muscles[m].displacements);
  }
}

}  // namespace
}  // namespace musclewarp
