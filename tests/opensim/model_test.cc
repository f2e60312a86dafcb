// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/model.h"

#include <gtest/gtest.h>

#include <string>

namespace musclewarp {
namespace {

TEST(Model, FindsPartsByName) {
  Model model;
  model.bodies.resize(3);
  model.bodies[0].name = "ground";
  model.bodies[1].name = "thigh";
  model.bodies[2].name = "shank";
  model.coordinates.resize(2);
  model.coordinates[0].name = "hip";
  model.coordinates[1].name = "knee";
  model.muscles.resize(1);
  model.muscles[0].name = "thigh";
  EXPECT_EQ(model.FindBody("ground"), 0);
  EXPECT_EQ(model.FindBody("shank"), 2);
  EXPECT_EQ(model.FindBody("knee"), -1);
  EXPECT_EQ(model.FindCoordinate("knee"), 1);
  EXPECT_EQ(model.FindCoordinate("Knee"), -1);
  EXPECT_EQ(model.FindMuscle("thigh"), 0);
  EXPECT_EQ(model.FindMuscle(""), -1);
}

// As two joints of OpenSim Creator have them (TellCoordinatesApart).
Model TwoFreeJoints() {
  Model model;
  model.coordinates.resize(3);
  model.coordinates[0].name = model.coordinates[0].joint = "knee";
  for (const int i : {1, 2}) {
    Coordinate& coordinate = model.coordinates[i];
    coordinate.joint = "free_" + std::to_string(i);
    coordinate.name = coordinate.joint + "/rx";
  }
  return model;
}

TEST(Model, FindsCoordinatesByTheirPaths) {
  const Model model = TwoFreeJoints();
  EXPECT_EQ(model.FindCoordinate("free_1/rx"), 1);
  EXPECT_EQ(model.FindCoordinate("/jointset/free_2/rx"), 2);
  EXPECT_EQ(model.FindCoordinate("/jointset/free_2/rx/value"), 2);
  EXPECT_EQ(model.FindCoordinate("/jointset/knee/knee"), 0);
  // Of another model, which has the coordinate in a joint of another name.
  EXPECT_EQ(model.FindCoordinate("/jointset/knee_r/knee/value"), 0);
  EXPECT_EQ(model.FindCoordinate("/jointset/free_3/rx"), -1);
  EXPECT_EQ(model.FindCoordinate("rx"), -1);
  EXPECT_EQ(model.FindCoordinate(""), -1);
  EXPECT_EQ(model.FindCoordinate("/"), -1);
}

TEST(Model, SaysWhyANameIsNoCoordinate) {
  const Model model = TwoFreeJoints();
  EXPECT_EQ(model.CoordinatesCalled("rx").size(), 2u);
  EXPECT_TRUE(model.CoordinatesCalled("knee").empty());
  EXPECT_EQ(WhyNoCoordinate(model, "ry"), "is not a coordinate of the model");
  EXPECT_EQ(WhyNoCoordinate(model, "rx"),
            "is the name of 2 coordinates, which are told apart by their "
            "joints: free_1/rx, free_2/rx");
}

}  // namespace
}  // namespace musclewarp
