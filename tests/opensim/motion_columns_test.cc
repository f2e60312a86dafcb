// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/motion_columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/input_errors.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// A model of the right side, with the names of OpenSim's gait models.
Model RightLeg() {
  Model model;
  model.path = "leg.osim";
  for (const char* name :
       {"pelvis_tx", "pelvis_ty", "hip_flexion_r", "knee_angle_r"}) {
    Coordinate coordinate;
    coordinate.name = name;
    model.coordinates.push_back(coordinate);
  }
  Joint joint;
  joint.name = "hip_r";
  model.joints.push_back(joint);
  return model;
}

StorageTable OneRow(const std::vector<std::string>& labels, double value = 1) {
  StorageTable table;
  table.labels = labels;
  table.times = {0};
  table.values.setConstant(1, labels.size(), value);
  return table;
}

MotionColumns Match(const std::vector<std::string>& labels) {
  return MatchColumns(RightLeg(), OneRow(labels), "m.mot");
}

TEST(MotionColumns, CoordinatesAreFoundByNameAndByPath) {
  const MotionColumns columns = Match({"knee_angle_r",
                                       "/jointset/hip_r/hip_flexion_r/value",
                                       "ground_pelvis/pelvis_tx/value",
                                       "/jointset/ground_pelvis/pelvis_ty"});
  EXPECT_THAT(columns.coordinates, ElementsAre(3, 2, 0, 1));
  EXPECT_THAT(columns.others, IsEmpty());
  EXPECT_THAT(Match({"hip_r/hip_flexion_r"}).coordinates, ElementsAre(2));
}

TEST(MotionColumns, ANameThatTwoJointsHaveIsNoOnes) {
  Model model = RightLeg();
  for (const char* joint : {"ball_1", "ball_2"}) {
    Coordinate coordinate;
    coordinate.joint = joint;
    coordinate.name = std::string(joint) + "/rx";
    model.coordinates.push_back(coordinate);
  }
  const MotionColumns columns =
      MatchColumns(model,
                   OneRow({"rx", "/jointset/ball_2/rx/value", "knee_angle_r"}),
                   "m.mot");
  EXPECT_THAT(columns.coordinates, ElementsAre(-1, 5, 3));
  EXPECT_THAT(columns.ambiguous, ElementsAre(0));
  EXPECT_THAT(columns.others, IsEmpty());
}

TEST(MotionColumns, WhatIsNoCoordinateIsLeftOut) {
  const std::vector<std::string> labels = {
      "ground_force_vx",  // twice, as in the files of Gait2392
      "ground_force_vx",
      "R.ASIS_tx",
      "/forceset/soleus_r",
      "/forceset/knee_angle_r",  // an actuator, not the coordinate
      "/jointset/hip_r/hip_flexion_r/acc",
      "hip_flexion_l",  // coordinates of other models
      "knee_angle_r_beta",
      "pelvis_tz",
      "/jointset/hip_l/hip_flexion_l/value"};
  const MotionColumns columns = Match(labels);
  EXPECT_THAT(columns.coordinates,
              ElementsAre(-1, -1, -1, -1, -1, -1, -1, -1, -1, -1));
  EXPECT_EQ(columns.others, labels);
}

TEST(MotionColumns, StatesAreExpected) {
  const MotionColumns columns = Match({"knee_angle_r",
                                       "knee_angle_r_u",
                                       "/jointset/hip_r/hip_flexion_r/speed",
                                       "/forceset/soleus_r/activation",
                                       "soleus_r.fiber_length"});
  EXPECT_THAT(columns.coordinates, ElementsAre(3, -1, -1, -1, -1));
  EXPECT_THAT(columns.others, IsEmpty());
}

TEST(MotionColumns, RefusesNamesThatAreNearlyThoseOfCoordinates) {
  for (const std::string& label :
       {std::string("knee_angel_r"),
        std::string("Knee_Angle_R"),
        std::string("knee_angle"),
        std::string("kneeangle_r"),
        std::string("/jointset/knee_r/kne_angle_r/value")}) {
    ExpectInputError(
        [&] {
          Match({"hip_flexion_r", label});
        },
        {"m.mot", label, "\"knee_angle_r\"", "rename"});
    // Beside the coordinate itself it is another one.
    EXPECT_THAT(Match({"knee_angle_r", label}).others, ElementsAre(label));
    // Nothing is lost with a column of zeros.
    EXPECT_THAT(
        MatchColumns(RightLeg(), OneRow({"hip_flexion_r", label}, 0), "m.mot")
            .others,
        ElementsAre(label));
  }
}

TEST(MotionColumns, RefusesTwoColumnsForOneCoordinate) {
  ExpectInputError(
      [] {
        Match({"knee_angle_r", "/jointset/knee_r/knee_angle_r/value"});
      },
      {"m.mot", "second one for the coordinate knee_angle_r"});
}

TEST(IsNearlyNamed, SidesAxesAndNumbersTellCoordinatesApart) {
  EXPECT_FALSE(IsNearlyNamed("hip_flexion_l", "hip_flexion_r"));
  EXPECT_FALSE(IsNearlyNamed("pelvis_tz", "pelvis_ty"));
  EXPECT_FALSE(IsNearlyNamed("Abs_t1", "Abs_t2"));
  EXPECT_FALSE(IsNearlyNamed("left_knee", "right_knee"));
  EXPECT_FALSE(IsNearlyNamed("pelvis_list", "pelvis_tilt"));
  EXPECT_FALSE(IsNearlyNamed("lumbar_bending", "lumbar_rotation"));
  EXPECT_TRUE(IsNearlyNamed("hip_abduction_r", "hip_adduction_r"));
  EXPECT_TRUE(IsNearlyNamed("hip_flexoin_r", "hip_flexion_r"));
  EXPECT_TRUE(IsNearlyNamed("knee", "kne"));
}

}  // namespace
}  // namespace musclewarp
