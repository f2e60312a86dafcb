// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/coordinate_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Model Leg() {
  return ReadModel(
      Written("leg.osim", Model4(Joint4("PlanarJoint", "knee tx ty"))));
}

StorageTable Table(const std::vector<std::string>& labels,
                   const std::vector<std::vector<double>>& rows) {
  StorageTable table;
  table.in_degrees = true;
  table.labels = labels;
  table.values.resize(rows.size(), labels.size());
  for (size_t i = 0; i < rows.size(); ++i) {
    table.times.push_back(0.1 * static_cast<double>(i));
    for (size_t k = 0; k < labels.size(); ++k) table.values(i, k) = rows[i][k];
  }
  return table;
}

void ExpectMotionRefused(const StorageTable& table,
                         std::vector<std::string> words) {
  words.push_back("m.mot");
  ExpectInputError([&] { MotionOf(Leg(), table, "m.mot"); }, words);
}

TEST(CoordinateMotion, DegreesAreForAnglesOnly) {
  StorageTable table = Table({"knee", "tx"}, {{90, 0.5}, {180, 0.5}});
  auto motion = MotionOf(Leg(), table, "m.mot");
  EXPECT_THAT(motion.values[0], ElementsAre(M_PI / 2, 0.5, 0));
  EXPECT_THAT(motion.values[1], ElementsAre(M_PI, 0.5, 0));
  EXPECT_THAT(motion.given, ElementsAre(0, 1));
  EXPECT_THAT(motion.moving, ElementsAre(0));
  table.in_degrees = false;
  motion = MotionOf(Leg(), table, "m.mot");
  EXPECT_EQ(motion.values[0][0], 90);
}

TEST(CoordinateMotion, ColumnsMayBePathsAndStatesArePassedOver) {
  const auto motion = MotionOf(Leg(),
                               Table({"/jointset/knee_joint/knee/value",
                                      "/jointset/knee_joint/knee/speed",
                                      "/forceset/m/activation",
                                      "tx_u"},
                                     {{90, 7, 1, 5}}),
                               "m.mot");
  EXPECT_THAT(motion.values[0], ElementsAre(M_PI / 2, 0, 0));
  EXPECT_TRUE(motion.warnings.empty());
}

TEST(CoordinateMotion, OneWarningCountsTheColumnsThatAreLeftOut) {
  std::vector<std::string> labels = {"knee"};
  for (int i = 0; i < 20; ++i) {
    labels.push_back("force_" + std::to_string(i));
  }
  const auto motion = MotionOf(
      Leg(), Table(labels, {std::vector<double>(labels.size(), 1)}), "m.mot");
  ASSERT_EQ(motion.warnings.size(), 1u);
  EXPECT_THAT(motion.warnings[0], HasSubstr("20 columns"));
  EXPECT_THAT(motion.warnings[0], HasSubstr("force_0, force_1, "));
  EXPECT_THAT(motion.warnings[0], HasSubstr("and 10 more"));
}

TEST(CoordinateMotion, RefusesTablesThatDoNotFit) {
  ExpectMotionRefused(Table({"knee", "/jointset/knee_joint/knee"}, {{1, 2}}),
                      {"second one for the coordinate knee"});
  ExpectMotionRefused(Table({"hip"}, {{0}}), {"no column", "knee, tx, ty"});
  StorageTable table = Table({"knee", "force"}, {{1, NAN}, {NAN, 2}});
  ExpectMotionRefused(table, {"row 1", "\"knee\"", "not finite"});
  table.lines = {7, 9};
  ExpectMotionRefused(table, {"line 9"});
  table.values(1, 0) = 3;
  EXPECT_EQ(MotionOf(Leg(), table, "m.mot").values.size(), 2u);
}

TEST(CoordinateMotion, SomethingHasToSayWhetherAnglesAreInDegrees) {
  StorageTable table = Table({"knee"}, {{90}});
  table.in_degrees.reset();
  ExpectMotionRefused(table, {"motion_in_degrees", "inDegrees=yes"});
  EXPECT_EQ(MotionOf(Leg(), table, "m.mot", true).values[0][0], M_PI / 2);
  EXPECT_EQ(MotionOf(Leg(), table, "m.mot", false).values[0][0], 90);
  // Lengths have no such choice.
  StorageTable lengths = Table({"tx"}, {{0.5}});
  lengths.in_degrees.reset();
  EXPECT_EQ(MotionOf(Leg(), lengths, "m.mot").values[0][1], 0.5);
}

TEST(CoordinateMotion, WhatIsAskedForWinsOverTheHeaderWithAWarning) {
  const auto motion = MotionOf(Leg(), Table({"knee"}, {{2}}), "m.mot", false);
  EXPECT_EQ(motion.values[0][0], 2);
  ASSERT_EQ(motion.warnings.size(), 1u);
  EXPECT_THAT(motion.warnings[0], HasSubstr("radians"));
}

}  // namespace
}  // namespace musclewarp
