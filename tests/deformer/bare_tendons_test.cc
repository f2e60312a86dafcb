// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/mesh/transformed.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::HasSubstr;

SceneBone BoneOf(const std::string& name,
                 const std::string& body,
                 const TriangleSoup& mesh) {
  SceneBone bone;
  bone.name = name;
  bone.points = mesh.points;
  bone.triangles = mesh.triangles;
  bone.body = body;
  return bone;
}

// A lower leg, forward, up and right being the axes, with the belly of a
// soleus: a spindle of 140 mm that lies behind the tibia and ends 120 mm above
// the heel.
Scene LegWithABelly(const std::string& muscle) {
  Scene scene;
  scene.axes = "ASR";
  scene.bones = {
      BoneOf("tibia", "tibia", Box(22, 340, 22)),
      BoneOf("fibula", "tibia", MovedBy(Box(12, 330, 12), {-18, -14, 29})),
      BoneOf("talus", "foot", MovedBy(Box(50, 25, 30), {0, -185, 0})),
      BoneOf("calcaneus", "foot", MovedBy(Box(70, 30, 30), {-25, -213, 3})),
      BoneOf("metatarsal_1", "foot", MovedBy(Box(60, 14, 14), {80, -218, -8})),
      BoneOf("metatarsal_5", "foot", MovedBy(Box(65, 12, 12), {55, -222, 40}))};
  TriangleSoup belly = Spindle(13, 70, 4);
  const Points points = belly.points;
  belly.points.col(0) = points.col(1);
  belly.points.col(1) = points.col(2);
  belly.points.col(2) = points.col(0);
  belly = MovedBy(belly, {-27, -10, 0});
  SceneMuscle named;
  named.name = muscle;
  named.points = belly.points;
  named.triangles = belly.triangles;
  scene.muscles = {named};
  return scene;
}

// The foot turned about the ankle, pointed for angles above 0, rad.
ScenePose Pointed(double angle) {
  ScenePose pose;
  pose.name = "pointed";
  Eigen::Affine3d motion = Eigen::Translation3d(0, -175, 0) *
                           Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitZ()) *
                           Eigen::Translation3d(0, 175, 0);
  pose.bodies["foot"] = motion.matrix();
  return pose;
}

DeformerOptions WithoutContact() {
  DeformerOptions options;
  options.frames.contact = ContactKind::kNone;
  options.prepare.muscle.hull.coarse_vertices = 100;
  return options;
}

// The mean of numbers by the name of a line.
double MeanOf(const std::map<std::string, double>& by_line) {
  double sum = 0;
  for (const auto& [line, value] : by_line) sum += value;
  return sum / static_cast<double>(by_line.size());
}

TEST(BareTendons, PullOnTheBelly) {
  Deformer deformer(LegWithABelly("soleus"), WithoutContact());
  const auto& tendons = deformer.scene().muscles[0].bare_tendons;
  ASSERT_EQ(tendons.size(), 1u);
  EXPECT_EQ(tendons[0].bone, "calcaneus");
  const Frame frame = deformer.MoveTo(Pointed(0.2));
  const Frame& rest = deformer.RestFrame();
  // The heel is some 60 mm behind the ankle, and goes up by 12 mm.
  const double path =
      MeanOf(frame.muscles[0].path_lengths) -
      MeanOf(deformer.MoveTo(Pointed(0)).muscles[0].path_lengths);
  EXPECT_NEAR(path, -12, 3);
  // The tendon keeps its length: the belly takes up nearly all of it.
  const double belly = MeanOf(frame.muscles[0].line_lengths) -
                       MeanOf(rest.muscles[0].line_lengths);
  EXPECT_NEAR(belly, path, 0.15 * std::abs(path));
  EXPECT_TRUE(frame.IsUsable()) << frame.FullReport();
}

TEST(BareTendons, AreInTheFramesFromTheBellyToTheBone) {
  Deformer deformer(LegWithABelly("soleus"), WithoutContact());
  const std::vector<Points> at_rest =
      deformer.RestFrame().muscles[0].bare_tendons;
  const ScenePose pose = Pointed(0.2);
  const std::vector<Points> moved =
      deformer.MoveTo(pose).muscles[0].bare_tendons;
  ASSERT_EQ(at_rest.size(), 3u);  // as many as lines
  ASSERT_EQ(moved.size(), 3u);
  for (size_t i = 0; i < moved.size(); ++i) {
    ASSERT_EQ(moved[i].rows(), at_rest[i].rows());
    // One end is fixed to the heel.
    const Points on_heel = Transformed(at_rest[i], pose.bodies.at("foot"));
    EXPECT_LT((moved[i] - on_heel).rowwise().norm().minCoeff(), 1e-6);
  }
}

TEST(BareTendons, AreNotMadeForMusclesWithoutAKnownName) {
  Deformer deformer(LegWithABelly("muscle_7"), WithoutContact());
  EXPECT_TRUE(deformer.scene().muscles[0].bare_tendons.empty());
  const Frame frame = deformer.MoveTo(Pointed(0.2));
  EXPECT_TRUE(frame.muscles[0].bare_tendons.empty());
}

// Guided lines do not go on, and a muscle that misses its bone is said to.
TEST(BareTendons, AreAShortcomingWhereLinesAreGuided) {
  DeformerOptions options = WithoutContact();
  options.prepare.made_lines = LineCourse::kGuided;
  Deformer deformer(LegWithABelly("soleus"), options);
  const Frame frame = deformer.MoveTo(Pointed(0.2));
  EXPECT_FALSE(frame.IsUsable());
  ASSERT_EQ(frame.shortcomings.size(), 1u);
  EXPECT_THAT(frame.shortcomings[0],
              HasSubstr("soleus by its name ends on the calcaneus"));
}

}  // namespace
}  // namespace musclewarp
