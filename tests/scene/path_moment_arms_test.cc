// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/path_moment_arms.h"

#include <gtest/gtest.h>

#include "musclewarp/scene/model_poses.h"
#include "scene/transform_checks.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

// Of central differences with steps of 1e-4 rad.
constexpr double kDifference = 1e-5;

// A leg with the path "m" of a muscle from thigh to shank and the line "own"
// between the same points.
Scene LegScene() {
  const std::string file =
      Written("leg.osim",
              Model4(Joint4("PinJoint", "knee"),
                     "",
                     Muscle("m",
                            Point4("p1", "thigh", "0.02 -0.1 0") +
                                Point4("p2", "shank", "0.03 -0.1 0"))));
  ModelRest rest;
  rest.coordinates = {{"knee", 0.0}};
  std::vector<std::string> notes;
  auto poses = std::make_shared<ModelPoses>(
      BindModel(ReadModel(file), rest, {"thigh", "shank"}, file, &notes));
  poses->muscles = {0};
  poses->moving_coordinates = {0};
  Scene scene;
  scene.muscles.resize(1);
  scene.muscles[0].lines = {LineOfMuscle(*poses, 0), LineOfMuscle(*poses, 0)};
  scene.muscles[0].lines[1].name = "own";
  scene.model = poses;
  return scene;
}

TEST(PathLengthsIn, IsThatOfTheTargetOfALineOfItsOwn) {
  ActionLine line;
  line.name = "l";
  line.rest.resize(3, 3);
  line.rest << 0, 0, 0, 3, 4, 0, 3, 4, 12;
  ScenePose pose;
  EXPECT_EQ(PathLengthsIn(pose, {line})[0], 17);
  pose.lines["l"] = 2 * line.rest;
  EXPECT_EQ(PathLengthsIn(pose, {line})[0], 34);
  // What the model knows comes first: it counts points that come and go.
  pose.path_lengths["l"] = 40;
  EXPECT_EQ(PathLengthsIn(pose, {line})[0], 40);
}

TEST(PathMomentArms, AreTheSameForAPathAndALineBetweenItsPoints) {
  const Scene scene = LegScene();
  for (const double knee : {-1.0, 0.0, 0.5}) {
    const ScenePose pose = PoseAt(*scene.model, {knee});
    const auto lengths = PathLengthsIn(pose, scene.muscles[0].lines);
    EXPECT_NEAR(lengths[0], lengths[1], kTransformRounding);
    const auto arms =
        PathMomentArms(scene, pose, PerturbedPosesOf(*scene.model, pose));
    EXPECT_NEAR(arms.at("m").at("knee"), arms.at("own").at("knee"), kDifference)
        << knee;
  }
}

TEST(PathMomentArms, AreMinusTheSlopeOfTheLength) {
  const Scene scene = LegScene();
  constexpr double kStep = 1e-3;
  const auto length = [&](double knee) {
    return PathLengthsIn(PoseAt(*scene.model, {knee}),
                         scene.muscles[0].lines)[0];
  };
  const double slope = (length(0.5 + kStep) - length(0.5 - kStep)) / 2 / kStep;
  // The second-order error of a step of 1e-3, of arms of some 30 mm.
  const ScenePose pose = PoseAt(*scene.model, {0.5});
  EXPECT_NEAR(PathMomentArms(scene, pose, PerturbedPosesOf(*scene.model, pose))
                  .at("m")
                  .at("knee"),
              -slope,
              1e-4);
}

}  // namespace
}  // namespace musclewarp
