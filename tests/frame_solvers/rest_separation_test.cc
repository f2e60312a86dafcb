// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/rest_separation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/input_errors.h"
#include "support/invalid_options.h"
#include "support/meshes.h"
#include "support/prepared_small_scene.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Of a sum over the triangles of a mesh, as a share.
constexpr double kRounding = 1e-9;

// The lower end of the bone, mm; the muscle ends at 60.
constexpr double kBoneBegins = 22;

// One muscle with a bone along the upper end of its axis, thinner than the
// muscle where the bone begins.
Scene SceneWithAnEndInABone() {
  Scene scene = SmallScene();
  scene.muscles.pop_back();
  scene.muscles[0].name = "psoas";
  const TriangleSoup femur =
      MovedBy(Box(16, 16, 60), {-12.5, 0, kBoneBegins + 30});
  scene.bones[1].points = femur.points;
  scene.bones[1].triangles = femur.triangles;
  return scene;
}

// One muscle with a plate across it that cuts off the uppermost 10 mm.
Scene SceneWithAnEndCutOff() {
  Scene scene = SceneWithAnEndInABone();
  const TriangleSoup plate = MovedBy(Box(40, 40, 6), {-12.5, 0, 47});
  scene.bones[1].points = plate.points;
  scene.bones[1].triangles = plate.triangles;
  return scene;
}

PrepareOptions SmallHulls() {
  PrepareOptions options;
  options.muscle.hull.coarse_vertices = 60;
  return options;
}

RestResult Separate(ReconstructionKind kind,
                    PreparedScene* scene,
                    RestSeparationOptions options = {}) {
  options.prepare = SmallHulls();
  options.reconstruction.kind = kind;
  return SeparateRest(options, ReferenceSolvers().single, {}, scene);
}

}  // namespace

TEST(SeparateRest, DoesNotRemakeWhatSeparatesAsItIs) {
  PreparedScene scene = PreparedSmallScene();
  const PreparedScene before = scene;
  const RestResult rest = Separate(ReconstructionKind::kAuto, &scene);
  EXPECT_TRUE(rest.intersections.IsClean());
  EXPECT_TRUE(rest.reconstructed.empty());
  EXPECT_FALSE(scene.as_delivered);
  EXPECT_EQ(scene.warnings, before.warnings);
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    EXPECT_FALSE(scene.muscles[i].mesh.reconstruction.is_done);
    EXPECT_EQ(scene.muscles[i].model.fine_rest,
              before.muscles[i].model.fine_rest);
  }
}

TEST(SeparateRest, RemakesAMuscleWithAnEndDeepInABone) {
  PreparedScene scene = PreparedSmallScene(SceneWithAnEndInABone());
  const double volume = scene.muscles[0].model.rest_volume;
  const RestResult rest = Separate(ReconstructionKind::kAuto, &scene);
  EXPECT_TRUE(rest.intersections.IsClean());
  ASSERT_TRUE(scene.as_delivered);
  EXPECT_GT(scene.as_delivered->triangle_pairs, 0);
  const PreparedMuscle& muscle = scene.muscles[0];
  const TriangleSoup made = {muscle.model.fine_rest,
                             muscle.model.fine_triangles};
  EXPECT_TRUE(CountDefects(made).IsClean());
  EXPECT_TRUE(SelfIntersections(made).empty());
  const SurfaceReconstruction& reconstruction = muscle.mesh.reconstruction;
  EXPECT_TRUE(reconstruction.is_done);
  EXPECT_EQ(rest.reconstructed, std::vector<int>{0});
  EXPECT_EQ(reconstruction.reason, ReconstructionReason::kCrossesBone);
  EXPECT_NEAR(reconstruction.volume_before, volume, kRounding * volume);
  EXPECT_NEAR(reconstruction.volume_after,
              SignedVolume(made.points, made.triangles),
              kRounding * volume);
  // The bone has about a sixth of the muscle inside it, which comes back beside
  // the bone, to half a per cent, but for what slivers take.
  EXPECT_NEAR(reconstruction.volume_after, volume, 0.01 * volume);
  EXPECT_GT(reconstruction.lost_area, 0);
  EXPECT_GT(reconstruction.place.z(), kBoneBegins);
  ASSERT_FALSE(scene.warnings.empty());
  EXPECT_THAT(scene.warnings.back(),
              AllOf(HasSubstr("psoas could not be separated"),
                    HasSubstr("it still crossed a bone"),
                    HasSubstr("cm3 before"),
                    HasSubstr("mm away at most")));
}

TEST(SeparateRest, RefusesSuchASceneIfNothingMayBeMadeAnew) {
  PreparedScene scene = PreparedSmallScene(SceneWithAnEndInABone());
  const Points before = scene.muscles[0].model.fine_rest;
  ExpectInputError([&] { Separate(ReconstructionKind::kNever, &scene); },
                   {"psoas crosses femur", "remake=auto", "mm deep"});
  EXPECT_EQ(scene.muscles[0].model.fine_rest, before);
}

TEST(SeparateRest, RemakesAMuscleOfWhichABoneCutsOffAnEnd) {
  PreparedScene scene = PreparedSmallScene(SceneWithAnEndCutOff());
  const RestResult as_it_is = Separate(ReconstructionKind::kNever, &scene);
  // Its end is pulled through to the side of its bulk, clean but far.
  EXPECT_TRUE(as_it_is.intersections.IsClean());
  EXPECT_EQ(as_it_is.displaced, std::vector<int>{0});
  EXPECT_FALSE(scene.muscles[0].mesh.reconstruction.is_done);

  const RestResult remade = Separate(ReconstructionKind::kAuto, &scene);
  EXPECT_TRUE(remade.intersections.IsClean());
  EXPECT_TRUE(remade.displaced.empty());
  EXPECT_TRUE(scene.muscles[0].mesh.reconstruction.is_done);
  EXPECT_EQ(scene.muscles[0].mesh.reconstruction.reason,
            ReconstructionReason::kDisplaced);
  constexpr double kPlateBegins = 44;
  EXPECT_LT(scene.muscles[0].model.fine_rest.col(2).maxCoeff(), kPlateBegins);
}

// A label that lost a half before it became a mesh: that half was elsewhere,
// and does not come back where a bone cuts off what is left.
TEST(SeparateRest, GrowsToTheVolumeOfTheMeshNotOfItsLabel) {
  Scene raw = SceneWithAnEndInABone();
  const double volume =
      SignedVolume(raw.muscles[0].points, raw.muscles[0].triangles);
  raw.muscles[0].delivered_volume = 2 * volume;
  PreparedScene scene = PreparedSmallScene(raw);
  Separate(ReconstructionKind::kAuto, &scene);
  EXPECT_TRUE(scene.muscles[0].mesh.reconstruction.is_done);
  EXPECT_NEAR(scene.muscles[0].model.rest_volume, volume, 0.02 * volume);
}

TEST(SeparateRest, RefusesAMuscleOfWhichLittleIsLeft) {
  Scene raw = SceneWithAnEndInABone();
  // Only the lowest tenth of its length is outside.
  const TriangleSoup femur = MovedBy(Box(16, 16, 200), {-12.5, 0, 52});
  raw.bones[1].points = femur.points;
  raw.bones[1].triangles = femur.triangles;
  PreparedScene scene = PreparedSmallScene(raw);
  ExpectInputError([&] { Separate(ReconstructionKind::kAuto, &scene); },
                   {"psoas", "% of the muscle", "in one frame"});
}

// Steps would push back what crosses itself.
RestSeparationOptions WithoutSteps() {
  RestSeparationOptions options;
  options.contact.max_rest_steps = 0;
  return options;
}

// A muscle one vertex of which has been pulled out through its other side.
PreparedScene SceneWithAMuscleThatCrossesItself() {
  Scene raw = SmallScene();
  raw.muscles.pop_back();
  PreparedScene scene = PreparedSmallScene(raw);
  Points& points = scene.muscles[0].model.fine_rest;
  int lowest = 0;
  points.col(1).minCoeff(&lowest);
  points(lowest, 1) = 20;  // the muscle ends at 12
  return scene;
}

// However far from all others it is.
TEST(SeparateRest, RefusesAMuscleThatCrossesItself) {
  PreparedScene scene = SceneWithAMuscleThatCrossesItself();
  ExpectInputError(
      [&] { Separate(ReconstructionKind::kNever, &scene, WithoutSteps()); },
      {"left crosses itself in", "pairs of triangles", "remake=auto"});
}

TEST(SeparateRest, RemakesAMuscleThatCrossesItself) {
  PreparedScene scene = SceneWithAMuscleThatCrossesItself();
  const RestResult rest =
      Separate(ReconstructionKind::kAuto, &scene, WithoutSteps());
  ASSERT_EQ(rest.reconstructed, std::vector<int>{0});
  EXPECT_EQ(scene.muscles[0].mesh.reconstruction.reason,
            ReconstructionReason::kCrossesItself);
  EXPECT_EQ(rest.intersections.self_pairs, 0);
  EXPECT_THAT(scene.warnings.back(), HasSubstr("(it crossed itself)"));
}

TEST(SeparateRest, LeavesWhatIsOnlyDisplacedIfThatIsAskedFor) {
  PreparedScene scene = PreparedSmallScene(SceneWithAnEndCutOff());
  RestSeparationOptions options;
  options.prepare = SmallHulls();
  options.reconstruction.reconstructs_displaced = false;
  const RestResult rest =
      SeparateRest(options, ReferenceSolvers().single, {}, &scene);
  EXPECT_EQ(rest.displaced, std::vector<int>{0});
  EXPECT_TRUE(rest.reconstructed.empty());
}

// Muscles without lines have nothing to be solved for, and separate all the
// same.
TEST(SeparateRest, NeedsNoLines) {
  Scene raw = SmallScene();
  for (SceneMuscle& muscle : raw.muscles) muscle.lines.clear();
  raw.muscles[1].points.col(0).array() -= 4;  // into the other one
  PrepareOptions prepare = SmallHulls();
  prepare.makes_lines = false;
  prepare.attachments = AttachmentKind::kNone;
  PreparedScene scene = PrepareScene(raw, prepare);
  const RestResult rest = Separate(ReconstructionKind::kNever, &scene);
  EXPECT_TRUE(rest.intersections.IsClean());
  for (size_t i = 0; i < scene.muscles.size(); ++i) {
    const MuscleModel& model = scene.muscles[i].model;
    EXPECT_TRUE(scene.scene.muscles[i].lines.empty());
    EXPECT_EQ(rest.state.free_coarse[i], model.coarse_rest);
    EXPECT_NEAR(SignedVolume(rest.state.points[i], model.fine_triangles),
                model.rest_volume,
                FrameRequirements().max_volume_error * model.rest_volume);
  }
}

TEST(ReconstructionOptions, NameWhatIsWrong) {
  ExpectValid(ReconstructionOptions());
  ExpectRefused<ReconstructionOptions>(
      [](auto* options) { options->margin_growth = 0.5; },
      "ReconstructionOptions::margin_growth is 0.5, allowed: 1 or above");
  ExpectRefused<ReconstructionOptions>(
      [](auto* options) { options->least_volume_fraction = 1.5; },
      "ReconstructionOptions::least_volume_fraction is 1.5, allowed: 0 to 1");
  ExpectRefused<ReconstructionOptions>(
      [](auto* options) { options->max_spacing = 0.1; },
      "ReconstructionOptions::max_spacing is 0.1, allowed: 0.4 or above");
}

}  // namespace musclewarp
