// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/model.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace musclewarp
