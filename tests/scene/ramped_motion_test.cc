// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/ramped_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "musclewarp/base/output_file.h"
#include "musclewarp/opensim/storage_table.h"
#include "support/input_errors.h"
#include "support/osim_models.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A knee that turns and shifts; "ty" is twice "tx".
Model ShiftingKnee() {
  const std::string coupler =
      R"(<CoordinateCouplerConstraint name="c"><coupled_coordinates_function>
      <LinearFunction><coefficients>2 0</coefficients></LinearFunction>
      </coupled_coordinates_function>
      <independent_coordinate_names>tx</independent_coordinate_names>
      <dependent_coordinate_name>ty</dependent_coordinate_name>
      </CoordinateCouplerConstraint>)";
  return ReadModel(Written(
      "leg.osim", Model4(Joint4("PlanarJoint", "knee tx ty"), coupler)));
}

CoordinateMotion Ramped(const std::string& motion,
                        const Model& model = ShiftingKnee()) {
  const std::string path = TestTempDir() + "/scene.json";
  WriteTextAtomically(path, R"({"motion": )" + motion + "}");
  return RampedMotion(JsonField::ParseFile(path).At("motion"), model);
}

void ExpectNotRamped(const std::string& motion,
                     std::vector<std::string> words) {
  words.push_back("scene.json: motion");
  ExpectInputError([&] { Ramped(motion); }, words);
}

std::vector<double> ValuesOf(const CoordinateMotion& motion, int coordinate) {
  std::vector<double> values;
  for (const auto& frame : motion.values) values.push_back(frame[coordinate]);
  return values;
}

TEST(RampedMotion, IsTheMotionOfAFileOfTheSameValues) {
  const Model model = ShiftingKnee();
  const CoordinateMotion ramped = Ramped(
      R"({"frames": 5, "coordinates": {"tx": [3, 9], "knee": [-10, 60, 0]}})",
      model);
  const std::string file = Written("leg.mot",
                                   "m\ninDegrees=yes\nendheader\n"
                                   "time knee tx\n0 -10 0.003\n0.25 25 0.0045\n"
                                   "0.5 60 0.006\n0.75 30 0.0075\n1 0 0.009\n");
  const CoordinateMotion read = MotionOf(model, ReadStorageTable(file), file);
  EXPECT_EQ(ramped.times, read.times);
  EXPECT_EQ(ramped.values, read.values);
  EXPECT_EQ(ramped.given, read.given);
  EXPECT_EQ(ramped.moving, read.moving);
  EXPECT_THAT(ramped.warnings, IsEmpty());
}

TEST(RampedMotion, FramesAtValuesHaveThemExactly) {
  // Thirds and sevenths are no whole numbers of binary digits.
  const CoordinateMotion motion = Ramped(R"({"frames": 22, "coordinates":
          {"knee": [0, 0], "tx": [100, 300, 700, -900]}})");
  ASSERT_EQ(motion.values.size(), 22u);
  const auto shifts = ValuesOf(motion, 1);
  EXPECT_EQ(shifts[0], 0.1);
  EXPECT_EQ(shifts[7], 0.3);
  EXPECT_EQ(shifts[14], 0.7);
  EXPECT_EQ(shifts[21], -0.9);
  EXPECT_EQ(motion.times.front(), 0);
  EXPECT_EQ(motion.times.back(), 1);
  // The knee is named and stands still.
  EXPECT_THAT(motion.given, ElementsAre(0, 1));
  EXPECT_THAT(motion.moving, ElementsAre(1));
}

TEST(RampedMotion, ASingleValueStaysThere) {
  const CoordinateMotion motion =
      Ramped(R"({"frames": 3, "coordinates": {"knee": [90], "tx": [0, 8]}})");
  EXPECT_THAT(ValuesOf(motion, 0), ElementsAre(M_PI / 2, M_PI / 2, M_PI / 2));
  EXPECT_THAT(motion.moving, ElementsAre(1));
  const CoordinateMotion pose =
      Ramped(R"({"frames": 1, "coordinates": {"knee": [90], "tx": [8]}})");
  EXPECT_THAT(pose.times, ElementsAre(0));
  EXPECT_THAT(pose.values, ElementsAre(ElementsAre(M_PI / 2, 0.008, 0.016)));
}

TEST(RampedMotion, CoordinatesThatFollowOthersDoSo) {
  const CoordinateMotion motion =
      Ramped(R"({"frames": 2, "coordinates": {"tx": [0, 8], "ty": [5]}})");
  EXPECT_THAT(ValuesOf(motion, 2), ElementsAre(0, 0.016));
}

TEST(RampedMotion, CoupledKindsAreTakenAsTheyAre) {
  Model model = ShiftingKnee();
  model.coordinates[0].kind = CoordinateKind::kCoupled;
  const CoordinateMotion motion =
      Ramped(R"({"frames": 2, "coordinates": {"knee": [0, 8]}})", model);
  EXPECT_THAT(ValuesOf(motion, 0), ElementsAre(0, 8));
}

TEST(RampedMotion, WarnsOfValuesThatNoFrameReaches) {
  const std::string values = R"("coordinates": {"knee": [0, 90, 0]}})";
  const CoordinateMotion motion = Ramped(R"({"frames": 2, )" + values);
  EXPECT_THAT(motion.warnings, ElementsAre(HasSubstr("the 3 values of knee")));
  EXPECT_THAT(Ramped(R"({"frames": 3, )" + values).warnings, IsEmpty());
}

TEST(RampedMotion, RefusesNumbersOfFrames) {
  const std::string moves = R"(, "coordinates": {"knee": [0, 9]}})";
  for (const std::string frames :
       {"1", "0", "-3", "2.5", "100001", "1e300", "\"9\"", "true", "null"}) {
    ExpectNotRamped(R"({"frames": )" + frames + moves, {"motion.frames: is "});
  }
  ExpectNotRamped(R"({"frames": 1)" + moves, {"is 1;", "from 2 to 100000"});
  ExpectNotRamped(R"({"frames": 0, "coordinates": {"knee": [0]}})", {"is 0;"});
  ExpectNotRamped(R"({"coordinates": {"knee": [0]}})", {"frames: is missing"});
  EXPECT_EQ(Ramped(R"({"frames": 1e5)" + moves).times.size(), 100000u);
}

TEST(RampedMotion, RefusesCoordinatesThatDoNotFit) {
  const auto refused = [](const std::string& coordinates,
                          const std::vector<std::string>& words) {
    ExpectNotRamped(R"({"frames": 2, "coordinates": )" + coordinates + "}",
                    words);
  };
  refused(R"({"knee": [0], "hip": [0, 9]})",
          {"coordinates: names \"hip\"", "leg.osim", "knee, tx, ty"});
  refused(R"({"kne": [0, 9]})", {"\"kne\"", "; did you mean knee? allowed: "});
  refused(R"({"knee": []})", {"coordinates.knee: is an array of 0", "[30]"});
  refused(R"({"knee": 30})", {"coordinates.knee: is 30", "give a list"});
  refused(R"({"knee": [0, "9"]})", {"coordinates.knee[1]: is \"9\""});
  refused(R"({"knee": [0, [9]]})", {"coordinates.knee[1]: is an array"});
  refused(R"({"tx": [0, -2e7]})", {"tx[1]: is -20000000.0", "-1e7 to 1e7"});
  refused("{}", {"coordinates: is empty"});
  refused("[1]", {"coordinates: is an array", "an object"});
}

TEST(RampedMotion, RefusesOtherKeys) {
  ExpectNotRamped(R"({"frames": 2, "coords": {"knee": [0, 9]}})",
                  {"unknown key \"coords\"", "frames, coordinates"});
  ExpectNotRamped(R"({"frames": 2})", {"coordinates: is missing"});
}

}  // namespace
}  // namespace musclewarp
