// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/rest_remaking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "motion/prepared_small_scene.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "support/input_errors.h"
#include "support/invalid_options.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

// One muscle, whose upper end lies in a bone.
Scene SceneWithAnEndInABone(double depth) {
  Scene scene = SmallScene();
  scene.muscles.pop_back();
  scene.muscles[0].name = "psoas";
  const TriangleSoup femur =
      MovedBy(Icosphere(25, 3), {-12.5, 0, 60 + 25 - depth});
  scene.bones[1].points = femur.points;
  scene.bones[1].triangles = femur.triangles;
  return scene;
}

FrameSolverOptions Certified() {
  FrameSolverOptions options;
  options.contact = ContactKind::kCertified;
  return options;
}

PrepareOptions SmallHulls() {
  PrepareOptions options;
  options.muscle.hull.coarse_vertices = 60;
  return options;
}

std::unique_ptr<FrameSolver> Make(RemakeKind kind, PreparedScene* scene) {
  RestRemakingOptions remaking;
  remaking.kind = kind;
  return MakeCleanFrameSolver(
      remaking, SmallHulls(), Certified(), ReferenceSolvers(), {}, scene);
}

}  // namespace

TEST(MakeCleanFrameSolver, DoesNotRemakeWhatSeparatesAsItIs) {
  PreparedScene scene = PreparedSmallScene();
  const PreparedScene before = scene;
  const auto solver = Make(RemakeKind::kAuto, &scene);
  EXPECT_TRUE(solver->contact().rest->IsClean());
  EXPECT_FALSE(scene.as_delivered);
  EXPECT_EQ(scene.warnings, before.warnings);
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    EXPECT_FALSE(scene.muscles[i].mesh.remaking.is_done);
    EXPECT_EQ(scene.muscles[i].model.fine_rest,
              before.muscles[i].model.fine_rest);
  }
}

TEST(MakeCleanFrameSolver, Explore) {
  for (const double depth : {15.0, 25.0, 35.0, 45.0}) {
    PreparedScene scene = PreparedSmallScene(SceneWithAnEndInABone(depth));
    try {
      const auto solver = Make(RemakeKind::kNever, &scene);
      std::cout << depth << " separates\n";
    } catch (const InputError& e) {
      std::cout << depth << " " << e.what() << "\n";
    }
    try {
      const auto solver = Make(RemakeKind::kAuto, &scene);
      std::cout << depth << " ok " << scene.muscles[0].mesh.remaking.is_done
                << (scene.warnings.empty() ? "" : scene.warnings.back())
                << "\n";
    } catch (const InputError& e) {
      std::cout << depth << " " << e.what() << "\n";
    }
  }
}

TEST(MakeCleanFrameSolver, LeavesOtherKindsOfContactAlone) {
  PreparedScene scene = PreparedSmallScene(SceneWithAnEndInABone(40));
  FrameSolverOptions options;
  options.contact = ContactKind::kNone;
  MakeCleanFrameSolver(
      {}, SmallHulls(), options, ReferenceSolvers(), {}, &scene);
  EXPECT_FALSE(scene.muscles[0].mesh.remaking.is_done);
  EXPECT_FALSE(scene.as_delivered);
}

TEST(RestRemakingOptions, NameWhatIsWrong) {
  ExpectValid(RestRemakingOptions());
  ExpectRefused<RestRemakingOptions>(
      [](auto* options) { options->margin = 0; },
      "RestRemakingOptions::margin is 0, allowed: above 0");
  ExpectRefused<RestRemakingOptions>(
      [](auto* options) { options->least_volume_share = 1.5; },
      "RestRemakingOptions::least_volume_share is 1.5, allowed: 0 to 1");
  ExpectRefused<RestRemakingOptions>(
      [](auto* options) { options->max_spacing = 0.1; },
      "RestRemakingOptions::max_spacing is 0.1, allowed: 0.4 or above");
}

}  // namespace musclewarp
