// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/place.h"

#include <gtest/gtest.h>

#include "motion/prepared_small_scene.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

class PlaceTest : public ::testing::Test {
 protected:
  PlaceTest()
      : scene_(PreparedSmallScene()),
        solver_(ReferenceSolvers().single),
        certified_(PrepareCertifiedScene(
            scene_, SceneMeshes(scene_), {}, {}, solver_, {})),
        mover_{scene_, certified_, pre_rotation_, solver_} {}

  const PreparedScene scene_;
  const PreRotationOptions pre_rotation_;
  const MuscleSolver solver_;
  const CertifiedScene certified_;
  const Mover mover_;
};

TEST_F(PlaceTest, OfAStateGivesTheStateBack) {
  SceneState state = certified_.rest;
  state.pose = FlexedPose(0.1);
  state.muscles[0].coarse(3, 1) += 2;
  Points& offset = state.muscles[1].corrections.fine_offset;
  offset = Points::Zero(scene_.muscles[1].model.fine_rest.rows(), 3);
  offset(7, 0) = 0.25;
  const SceneState back = StateOf(mover_, PlaceOf(mover_, state));
  EXPECT_EQ(back.pose.name, "flexed");
  ASSERT_EQ(back.muscles.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back.muscles[i].coarse, state.muscles[i].coarse);
    EXPECT_EQ(back.free_coarse[i], state.free_coarse[i]);
    // Added to vertices of up to 100 mm and subtracted again.
    EXPECT_LT((FinePoints(scene_.muscles[i].model, back.muscles[i]) -
               FinePoints(scene_.muscles[i].model, state.muscles[i]))
                  .norm(),
              1e-10);
  }
}

TEST_F(PlaceTest, HasTheBonesWhereThePoseHasThem) {
  SceneState state = certified_.rest;
  state.pose = FlexedPose(0.1);
  const Place place = PlaceOf(mover_, state);
  ASSERT_EQ(place.surfaces.bones_from_rest.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(place.surfaces.bones_from_rest[i],
              BodyTransform(state.pose, scene_.bones[i].body));
  }
}

}  // namespace
}  // namespace musclewarp
