// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "frames/frame_arms.h"
#include "frames/two_over_a_knee.h"
#include "musclewarp/motion/pose_pushes.h"
#include "musclewarp/preparation/bone_pushes.h"

namespace musclewarp {
namespace {

// A spur of the shank, 1 mm beside the right muscle, that comes into it as the
// shank leans.
PreparedScene PreparedWithASpur() {
  Scene scene = TwoOverAKnee();
  const TriangleSoup spur = MovedBy(Icosphere(8, 3), {25, -430, 32});
  scene.bones.push_back({"spur", spur.points, spur.triangles, "shank"});
  PreparedScene prepared = Prepared(1, scene);
  AddBonePushes({}, &prepared);
  return prepared;
}

TEST(AddMomentArms, CountThePushOfBones) {
  const PreparedScene scene = PreparedWithASpur();
  const MuscleSolver solver = TightReference();
  const auto pose_at = [&](double lean) {
    return WithPushes(scene, {}, At(scene, 0.2, -0.3, lean));
  };
  const ScenePose pose = pose_at(0.25);
  ASSERT_GT(pose.pushes.at("right").rowwise().norm().maxCoeff(), 2);
  const Frame frame = FrameWithArms(
      scene, pose, {{SolvedFree(scene, solver, pose), {}}, {}, {}});
  const std::vector<double> arms = Arms(scene, frame, "lean");
  constexpr double kBeside = 1e-3;
  const std::vector<double> before =
      Lengths(scene, SolvedFree(scene, solver, pose_at(0.25 - kBeside)));
  const std::vector<double> after =
      Lengths(scene, SolvedFree(scene, solver, pose_at(0.25 + kBeside)));
  double slopes = 0, differences = 0;
  for (size_t k = 5; k < arms.size(); ++k) {
    const double slope = -(after[k] - before[k]) / (2 * kBeside);
    slopes += slope * slope;
    differences += (arms[k] - slope) * (arms[k] - slope);
  }
  // Only the bone moves the right muscle.
  EXPECT_GT(std::sqrt(slopes), 0.5);
  EXPECT_LT(std::sqrt(differences), 0.01 * std::sqrt(slopes));
  // The hip moves everything as one.
  for (const double arm : Arms(scene, frame, "hip")) EXPECT_EQ(arm, 0);
}

}  // namespace
}  // namespace musclewarp
