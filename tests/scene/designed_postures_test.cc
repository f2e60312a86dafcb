// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/designed_postures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/osim_models.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::HasSubstr;
using ::testing::Le;

// Rounding of degrees to radians.
constexpr double kRounding = 1e-12;

// A knee that turns and shifts; "ty" is twice "tx".
Model ShiftingKnee() {
  const std::string coupler =
      R"(<CoordinateCouplerConstraint name="c"><coupled_coordinates_function>
      <LinearFunction><coefficients>2 0</coefficients></LinearFunction>
      </coupled_coordinates_function>
      <independent_coordinate_names>tx</independent_coordinate_names>
      <dependent_coordinate_name>ty</dependent_coordinate_name>
      </CoordinateCouplerConstraint>)";
  Model model = ReadModel(Written(
      "leg.osim", Model4(Joint4("PlanarJoint", "knee tx ty"), coupler)));
  model.coordinates[0].range = {-RadiansOf(10), RadiansOf(120)};
  model.coordinates[1].range = {-0.005, 0.015};
  return model;
}

DesignedPostures Designed(const std::string& motion,
                          const Model& model = ShiftingKnee()) {
  const std::string path = TestTempDir() + "/scene.json";
  WriteTextAtomically(path, R"({"motion": )" + motion + "}");
  std::vector<std::string> bodies;
  for (const Body& body : model.bodies) bodies.push_back(body.name);
  return ReadDesignedPostures(
      JsonField::ParseFile(path).At("motion"), model, bodies);
}

void ExpectRefused(const std::string& motion, std::vector<std::string> words) {
  words.push_back("scene.json: motion");
  ExpectInputError([&] { Designed(motion); }, words);
}

std::vector<double> ValuesOf(const CoordinateMotion& motion, int coordinate) {
  std::vector<double> values;
  for (const auto& frame : motion.values) values.push_back(frame[coordinate]);
  return values;
}

TEST(DesignedPostures, CoverTheirRanges) {
  const DesignedPostures postures = Designed(R"({"design": "latin_hypercube",
      "postures": 100, "coordinates": {"knee": [0, 90], "tx": [-10, 10]}})");
  EXPECT_EQ(postures.design, "latin_hypercube");
  ASSERT_EQ(postures.motion.values.size(), 100u);
  EXPECT_THAT(postures.motion.given, ElementsAre(0, 1));
  EXPECT_THAT(postures.motion.moving, ElementsAre(0, 1));
  const auto expect_covered =
      [](std::vector<double> values, double low, double high) {
        std::sort(values.begin(), values.end());
        const double interval = (high - low) / 100;
        for (int i = 0; i < 100; ++i) {
          EXPECT_THAT(values[i],
                      AllOf(Ge(low + interval * i - kRounding),
                            Le(low + interval * (i + 1) + kRounding)));
        }
      };
  expect_covered(ValuesOf(postures.motion, 0), 0, RadiansOf(90));
  expect_covered(ValuesOf(postures.motion, 1), -0.01, 0.01);
}

TEST(DesignedPostures, CoupledCoordinatesFollow) {
  const CoordinateMotion motion =
      Designed(R"({"design": "latin_hypercube", "postures": 5,
                   "coordinates": {"tx": [-10, 10]}})")
          .motion;
  for (const CoordinateValues& values : motion.values) {
    EXPECT_EQ(values[2], 2 * values[1]);
  }
}

TEST(DesignedPostures, OfAGridHaveTheEndsOfTheRanges) {
  const DesignedPostures postures = Designed(R"({"design": "grid",
      "postures": 7, "coordinates": {"knee": [0, 90], "tx": [-10, 10]}})");
  EXPECT_THAT(postures.note, HasSubstr("6 postures of a grid"));
  std::vector<double> knee = ValuesOf(postures.motion, 0);
  EXPECT_THAT(
      knee,
      ElementsAre(
          0, 0, RadiansOf(45), RadiansOf(45), RadiansOf(90), RadiansOf(90)));
  EXPECT_THAT(ValuesOf(postures.motion, 1),
              ElementsAre(-0.01, 0.01, -0.01, 0.01, -0.01, 0.01));
}

TEST(DesignedPostures, TakeRangesOfTheModel) {
  const std::string of_model = R"({"design": "grid", "postures": 4)";
  const auto expected = ValuesOf(Designed(of_model + R"(, "coordinates":
      {"knee": [-10, 120], "tx": [-5, 15]}})")
                                     .motion,
                                 0);
  for (const std::string coordinates :
       {R"(, "coordinates": {"knee": "model", "tx": [-5, 15]}})",
        R"(, "coordinates": ["tx", "knee"]})",
        "}"}) {
    const DesignedPostures postures = Designed(of_model + coordinates);
    const auto knee = ValuesOf(postures.motion, 0);
    ASSERT_EQ(knee.size(), expected.size());
    for (size_t i = 0; i < knee.size(); ++i) {
      EXPECT_NEAR(knee[i], expected[i], kRounding);
    }
    EXPECT_THAT(postures.note,
                HasSubstr("knee from -10 to 120 degrees, tx from -5 to 15 mm"));
  }
}

TEST(DesignedPostures, LeaveWhatMovesAllBodiesAlikeAlone) {
  // Only the bodies of the scene count: of one alone, nothing moves.
  const Model model = ShiftingKnee();
  const std::string path =
      Written("scene.json", R"({"motion": {"design": "grid", "postures": 4}})");
  ExpectInputError(
      [&] {
        ReadDesignedPostures(JsonField::ParseFile(path).At("motion"),
                             model,
                             {model.bodies.back().name});
      },
      {"no free coordinate of", "moves the bones"});
}

TEST(DesignedPostures, AreThoseOfTheirSeed) {
  const auto knee = [](const std::string& seed) {
    return ValuesOf(Designed(R"({"design": "latin_hypercube", "postures": 9,
        "coordinates": {"knee": [0, 90]})" +
                             seed + "}")
                        .motion,
                    0);
  };
  EXPECT_EQ(knee(""), knee(R"(, "seed": 1)"));
  EXPECT_NE(knee(""), knee(R"(, "seed": 2)"));
}

TEST(DesignedPostures, AreVisitedFromRestOutwards) {
  const Model model = ShiftingKnee();
  DesignedPostures postures = Designed(R"({"design": "grid", "postures": 5,
      "coordinates": {"knee": [-20, 60]}})");
  CoordinateValues rest = DefaultValues(model);
  rest[0] = RadiansOf(21);
  const std::vector<int> from = VisitAsTree(model, rest, &postures.motion);
  EXPECT_THAT(from, ElementsAre(-1, 0, 1, -1, 3));
  const auto knee = ValuesOf(postures.motion, 0);
  EXPECT_THAT(knee,
              ElementsAre(RadiansOf(20),
                          RadiansOf(0),
                          RadiansOf(-20),
                          RadiansOf(40),
                          RadiansOf(60)));
}

TEST(DesignedPostures, RefuseWhatTheyDoNotKnow) {
  const std::string grid = R"({"design": "grid", "postures": 9)";
  const std::string sampled =
      R"({"design": "latin_hypercube", "coordinates": {"knee": [0, 9]})";
  ExpectRefused(R"({"design": "sobol", "postures": 4})",
                {"design: is \"sobol\"", "\"latin_hypercube\", \"grid\""});
  ExpectRefused(grid + R"(, "frames": 4})", {"unknown key \"frames\""});
  ExpectRefused(grid + R"(, "seed": 4})", {"seed: is given for a grid"});
  ExpectRefused(sampled + "}", {"postures: is missing"});
  for (const std::string postures : {"0", "-1", "2.5", "20001", "\"9\""}) {
    ExpectRefused(sampled + R"(, "postures": )" + postures + "}",
                  {"postures: is "});
  }
  for (const std::string seed : {"-1", "0.5", "4294967296"}) {
    ExpectRefused(sampled + R"(, "postures": 9, "seed": )" + seed + "}",
                  {"seed: is ", "0 to 4294967295"});
  }
  ExpectRefused(R"({"design": "grid", "postures": 3})",
                {"postures: is 3, too few for a grid of 2 coordinates"});
}

TEST(DesignedPostures, RefuseCoordinatesAndRanges) {
  const auto refused = [](const std::string& coordinates,
                          const std::vector<std::string>& words) {
    ExpectRefused(R"({"design": "grid", "postures": 9, "coordinates": )" +
                      coordinates + "}",
                  words);
  };
  refused(R"({"kne": [0, 9]})", {"\"kne\"", "did you mean knee"});
  refused(R"({"ty": [0, 9]})", {"names ty, which the model couples"});
  refused(R"({"knee": [9, 0]})", {"knee: is no range"});
  refused(R"({"knee": [9]})", {"knee: is no range"});
  refused(R"({"knee": [1, 2, 3]})", {"knee: is no range"});
  refused(R"({"knee": 9})", {"knee: is 9"});
  refused(R"({"knee": "modell"})", {"knee: is \"modell\"", "\"model\""});
  refused(R"(["knee", "knee"])", {"names knee more than once"});
  refused("{}", {"is empty"});
  refused("[]", {"is empty"});
  refused("4", {"coordinates: is 4"});
}

TEST(DesignedPostures, RefuseLockedCoordinatesAndThoseWithoutRange) {
  Model model = ShiftingKnee();
  model.coordinates[1].range.reset();
  const std::string tx =
      R"({"design": "grid", "postures": 9, "coordinates": {"tx": "model"}})";
  ExpectInputError([&] { Designed(tx, model); },
                   {"tx: has no range for tx", "such as"});
  model.coordinates[1].is_locked = true;
  ExpectInputError([&] { Designed(tx, model); }, {"which the model locks"});
  // Without names, it is left alone.
  const DesignedPostures postures =
      Designed(R"({"design": "grid", "postures": 3})", model);
  EXPECT_THAT(postures.motion.given, ElementsAre(0));
}

}  // namespace
}  // namespace musclewarp
