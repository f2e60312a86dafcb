// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/articulated_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A femur and a tibia with a hip that failed, a knee, and a patella that
// follows the knee.
Articulation KneeOnly() {
  Articulation found;
  for (const char* name : {"femur", "tibia"}) {
    Bone bone;
    bone.name = std::string(name) + "_right";
    bone.body = std::string(name) + "_r";
    found.bones.push_back(bone);
    found.bodies.push_back(bone.body);
  }
  FoundJoint hip, knee, patella;
  hip.kind = JointKind::kHip;
  hip.verdict.Fail("no head");
  knee.kind = JointKind::kKnee;
  knee.verdict.Weaken("coarse");
  patella.kind = JointKind::kPatella;
  patella.coupling.coordinate = "knee_angle_r";
  found.joints = {hip, patella, knee};
  return found;
}

JointMotion Swept(const std::string& coordinate, int frames) {
  JointMotion motion;
  motion.name = "bend";
  motion.frames = frames;
  motion.sweeps = {{coordinate, 10, 50}};
  return motion;
}

TEST(CoordinateNames, AreThoseOfJointsThatWereFoundAndFollowNoOther) {
  EXPECT_THAT(CoordinateNames(KneeOnly()), ElementsAre("knee_angle_r"));
  CheckCoordinates(Swept("knee_angle_r", 5), KneeOnly(), "a motion");
  for (const char* name : {"hip_flexion_r", "patella_angle_r"}) {
    ExpectInputError(
        [&] { CheckCoordinates(Swept(name, 5), KneeOnly(), "a motion"); },
        {"a motion", name, "which no joint", "allowed: knee_angle_r"});
  }
}

TEST(MotionsOfRanges, GoThroughTheRangeOfEachCoordinate) {
  const std::vector<JointMotion> motions = MotionsOfRanges(KneeOnly());
  ASSERT_EQ(motions.size(), 1u);
  EXPECT_EQ(motions[0].name, "knee_angle_r");
  ASSERT_EQ(motions[0].sweeps.size(), 1u);
  EXPECT_EQ(motions[0].sweeps[0].from, 0);
  EXPECT_EQ(motions[0].sweeps[0].to, 120);
}

// From the pose of the scan, in which the knee may be bent, on by 30 degrees.
TEST(FirstMotion, BendsTheFirstJointThatWasFoundFromTheScanOn) {
  Articulation found = KneeOnly();
  const Eigen::AngleAxisd bent(0.2, -Eigen::Vector3d::UnitZ());
  found.joints[2].child_axes = bent.toRotationMatrix();
  const JointMotion motion = FirstMotion(found);
  EXPECT_EQ(motion.name, "knee_angle_r");
  EXPECT_EQ(motion.frames, 7);
  ASSERT_EQ(motion.sweeps.size(), 1u);
  const double scan = 0.2 * 180 / M_PI;
  EXPECT_NEAR(motion.sweeps[0].from, scan, 1e-9);
  EXPECT_NEAR(motion.sweeps[0].to, scan + 30, 1e-9);
  found.joints.pop_back();
  EXPECT_THAT(FirstMotion(found).sweeps, IsEmpty());
}

TEST(MotionTable, IsEvenOverASecond) {
  const StorageTable table = MotionTable(Swept("knee_angle_r", 5));
  EXPECT_EQ(table.name, "bend");
  EXPECT_TRUE(table.in_degrees);
  EXPECT_THAT(table.labels, ElementsAre("knee_angle_r"));
  EXPECT_THAT(table.times, ElementsAre(0, 0.25, 0.5, 0.75, 1));
  ASSERT_EQ(table.values.rows(), 5);
  for (int frame = 0; frame < 5; ++frame) {
    EXPECT_EQ(table.values(frame, 0), 10 + 10 * frame);
  }
}

TEST(MotionTable, OfOneFrameHasItsBeginning) {
  const StorageTable table = MotionTable(Swept("knee_angle_r", 1));
  EXPECT_THAT(table.times, ElementsAre(0));
  EXPECT_EQ(table.values(0, 0), 10);
}

TEST(EndBodiesOf, AreNamedByThemselvesOrByTheirBones) {
  const Articulation found = KneeOnly();
  EXPECT_THAT(EndBodiesOf(found, "vastus", "", ""), IsEmpty());
  EXPECT_THAT(EndBodiesOf(found, "vastus", "femur_r", "tibia_right"),
              ElementsAre("femur_r", "tibia_r"));
  ExpectInputError([&] { EndBodiesOf(found, "vastus", "femur_r", ""); },
                   {"vastus", "has an origin and no insertion"});
  ExpectInputError([&] { EndBodiesOf(found, "vastus", "", "femur_r"); },
                   {"vastus", "has an insertion and no origin"});
  ExpectInputError([&] { EndBodiesOf(found, "vastus", "femur_r", "tibia_l"); },
                   {"ends on", "tibia_l", "neither a body nor a bone"});
}

TEST(ArticulatedSceneJson, HasMeshesBodiesAndTheMotion) {
  ArticulatedSceneParts parts;
  parts.name = "leg";
  parts.bones = {{"tibia_right", "t.stl"}, {"femur_right", "f.stl"}};
  parts.muscles = {{"vastus", "v.stl", "femur_right", "tibia_r", 1500},
                   {"sartorius", "s.stl"}};
  const auto scene =
      ArticulatedSceneJson(KneeOnly(), parts, Swept("knee_angle_r", 5));
  EXPECT_EQ(scene.at("name"), "leg");
  EXPECT_EQ(scene.at("units"), "mm");
  EXPECT_EQ(scene.at("axes"), "LPS");
  EXPECT_EQ(scene.at("side"), "right");
  EXPECT_EQ(scene.at("model"), "model.osim");
  const auto& bones = scene.at("bones");
  ASSERT_EQ(bones.size(), 2u);
  EXPECT_EQ(bones[0].at("mesh"), "f.stl");
  EXPECT_EQ(bones[0].at("body"), "femur_r");
  EXPECT_EQ(bones[1].at("mesh"), "t.stl");
  const auto& muscles = scene.at("muscles");
  EXPECT_EQ(muscles[0].at("delivered_volume_mm3"), 1500);
  EXPECT_EQ(muscles[0].at("end_bodies").dump(), R"(["femur_r","tibia_r"])");
  EXPECT_FALSE(muscles[1].contains("delivered_volume_mm3"));
  EXPECT_FALSE(muscles[1].contains("end_bodies"));
  const auto& motion = scene.at("motion");
  EXPECT_EQ(motion.at("frames"), 5);
  EXPECT_EQ(motion.at("coordinates").dump(), R"({"knee_angle_r":[10.0,50.0]})");
  EXPECT_EQ(scene.at("model_rest").dump(),
            R"({"coordinates":{},"in_degrees":true})");
  parts.axes = "";
  const auto still =
      ArticulatedSceneJson(KneeOnly(), parts, Swept("knee_angle_r", 1));
  EXPECT_FALSE(still.contains("axes"));
  EXPECT_EQ(still.at("motion").at("coordinates").dump(),
            R"({"knee_angle_r":[10.0]})");
}

}  // namespace
}  // namespace musclewarp
