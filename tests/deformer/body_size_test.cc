// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/body_size.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/deformer/mesh_separation.h"
#include "musclewarp/scene/scaled_scene.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/small_scene.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

Scene Scaled(double factor, Scene scene) {
  ScaleLengths(factor, &scene);
  return scene;
}

ScenePose Scaled(double factor, ScenePose pose) {
  ScaleLengths(factor, &pose);
  return pose;
}

// The small scene with muscles of 35 mm, by the cube roots of their volumes:
// the size of those of a human leg.
Scene SceneOfLegSize() { return Scaled(1.25, SmallScene()); }

// The pose flexed and shifted, so that places and translations are not zero.
ScenePose ShiftedPose(double factor) {
  ScenePose pose = FlexedPose(0.1);
  pose.bodies["femur"].topRightCorner<3, 1>() << 1, 0.5, -0.25;
  return Scaled(factor, pose);
}

DeformerOptions WithFewHullVertices() {
  DeformerOptions options;
  options.prepare.muscle.hull.coarse_vertices = 60;
  options.prepare.fibres.fibres = 3;
  options.frames.measures.vertex_gaps = true;
  return options;
}

// A mouse, a rat and a whale, against a human.
constexpr double kFactors[] = {1.0 / 32, 1.0 / 4, 16};

TEST(BodySize, IsOneForHumansOfAnySize) {
  for (const double factor : {0.7, 1.0, 2.0, 3.0}) {
    EXPECT_EQ(BodySizeOf(Scaled(factor, SmallScene())), 1) << factor;
  }
}

TEST(BodySize, IsThePowerOfTwoByWhichASceneIsLarger) {
  for (const double factor : kFactors) {
    EXPECT_EQ(BodySizeOf(Scaled(factor, SceneOfLegSize())), factor);
    // By any factor: what is left is less than a factor of two.
    EXPECT_EQ(BodySizeOf(Scaled(1.4 * factor, SceneOfLegSize())), factor);
  }
}

TEST(BodySize, IsThatOfTheMusclesThatHaveAVolume) {
  Scene scene = Scaled(1.0 / 32, SceneOfLegSize());
  scene.muscles[0].triangles.resize(0, 3);
  EXPECT_EQ(BodySizeOf(scene), 1.0 / 32);
  scene.muscles[1].triangles.resize(0, 3);
  EXPECT_EQ(BodySizeOf(scene), 1);
}

// Fields that differ by a factor to the last bit.
void ExpectScaled(double factor, const Frame& frame, const Frame& scaled) {
  ASSERT_EQ(frame.muscles.size(), scaled.muscles.size());
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    const MuscleFrame& a = frame.muscles[i];
    const MuscleFrame& b = scaled.muscles[i];
    EXPECT_EQ(factor * a.points, b.points);
    EXPECT_EQ(factor * a.gaps, b.gaps);
    EXPECT_EQ(a.volume_ratio, b.volume_ratio);
    EXPECT_EQ(a.solver.iterations, b.solver.iterations);
    EXPECT_EQ(factor * a.max_bone_push, b.max_bone_push);
    EXPECT_EQ(factor * a.max_contact_displacement, b.max_contact_displacement);
    ASSERT_EQ(a.fibres.size(), b.fibres.size());
    for (size_t k = 0; k < a.fibres.size(); ++k) {
      EXPECT_EQ(factor * a.fibres[k], b.fibres[k]);
    }
  }
  for (size_t i = 0; i < frame.bones.size(); ++i) {
    EXPECT_EQ(factor * frame.bones[i], scaled.bones[i]);
  }
  EXPECT_EQ(frame.pose_steps, scaled.pose_steps);
  ASSERT_EQ(frame.intersections.gaps.size(), scaled.intersections.gaps.size());
  for (size_t i = 0; i < frame.intersections.gaps.size(); ++i) {
    EXPECT_EQ(factor * frame.intersections.gaps[i].at_least_mm,
              scaled.intersections.gaps[i].at_least_mm);
  }
  EXPECT_EQ(frame.shortcomings.size(), scaled.shortcomings.size());
}

TEST(BodySize, AScaledSceneGivesTheScaledFramesToTheLastBit) {
  Deformer human(SceneOfLegSize(), WithFewHullVertices());
  const Frame frame = human.MoveTo(ShiftedPose(1));
  ASSERT_FALSE(frame.intersections.gaps.empty());
  for (const double factor : kFactors) {
    Deformer animal(Scaled(factor, SceneOfLegSize()), WithFewHullVertices());
    ExpectScaled(factor, frame, animal.MoveTo(ShiftedPose(factor)));
    ExpectScaled(factor, frame, animal.SolveAlone(ShiftedPose(factor)));
    ExpectScaled(factor, human.RestFrame(), animal.RestFrame());
    EXPECT_EQ(factor * human.contact().gap, animal.contact().gap);
    const MuscleModel& model = human.scene().muscles[0].model;
    const MuscleModel& scaled = animal.scene().muscles[0].model;
    EXPECT_EQ(factor * model.coarse_rest, scaled.coarse_rest);
    EXPECT_EQ(factor * factor * factor * model.rest_volume, scaled.rest_volume);
    EXPECT_EQ(animal.ExpectedSteps(nullptr, ShiftedPose(factor)),
              human.ExpectedSteps(nullptr, ShiftedPose(1)));
  }
}

TEST(BodySize, IsNotThatOfAMeshInAWrongUnit) {
  DeformerOptions options = WithFewHullVertices();
  options.lengths_in_mm = {"gap"};
  Scene metres = Scaled(1e-3, SceneOfLegSize());
  for (SceneMuscle& muscle : metres.muscles) muscle.mm_per_unit = 1;
  ExpectInputError([&] { Deformer(metres, options); },
                   {"mm across", "is it in metres?"});
}

TEST(BodySize, IsNotThatOfAMeshWithoutPlaces) {
  Scene scene = SceneOfLegSize();
  scene.muscles[0].points(0, 0) = std::nan("");
  ExpectInputError([&] { Deformer(scene, WithFewHullVertices()); },
                   {"left: point 0", "allowed"});
}

TEST(BodySize, ASceneBeyondHumanSizeSaysSo) {
  const Scene human = InBodyUnits(SceneOfLegSize());
  EXPECT_TRUE(human.notes.empty());
  EXPECT_EQ(human.muscles[0].points, SceneOfLegSize().muscles[0].points);
  const Scene mouse = InBodyUnits(Scaled(1.0 / 32, SceneOfLegSize()));
  EXPECT_EQ(mouse.muscles[0].points, SceneOfLegSize().muscles[0].points);
  ASSERT_EQ(mouse.notes.size(), 1u);
  EXPECT_THAT(mouse.notes[0], HasSubstr("are 1/32 of human size; lengths"));
  const Scene whale = InBodyUnits(Scaled(16, SceneOfLegSize()));
  EXPECT_THAT(whale.notes[0], HasSubstr("are 16 times human size; lengths"));
}

// Overlapping spheres, as large as muscles of a leg.
Scene OverlappingSpheres(double factor) {
  Scene scene;
  const TriangleSoup a = Icosphere(25, 3);
  const TriangleSoup b = MovedBy(Icosphere(25, 3), {48, 1, 2});
  scene.muscles.push_back({"a", a.points, a.triangles});
  scene.muscles.push_back({"b", b.points, b.triangles});
  return Scaled(factor, scene);
}

TEST(BodySize, ScaledMeshesAreSeparatedAlike) {
  RestSeparationOptions options = MeshSeparationOptions();
  options.prepare.muscle.hull.coarse_vertices = 60;
  const MeshSeparation human =
      SeparateMeshes(OverlappingSpheres(1), options, {});
  ASSERT_GT(human.before.max_depth_mm, 1);
  for (const double factor : kFactors) {
    const MeshSeparation animal =
        SeparateMeshes(OverlappingSpheres(factor), options, {});
    ExpectScaled(factor, human.frame, animal.frame);
    EXPECT_EQ(factor * human.before.max_depth_mm, animal.before.max_depth_mm);
    EXPECT_EQ(factor * human.gap, animal.gap);
  }
}

}  // namespace
}  // namespace musclewarp
