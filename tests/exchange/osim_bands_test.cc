// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/osim_bands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/opensim/dynamics.h"
#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string MuscleWith(const std::string& name, const std::string& force) {
  return Replaced(
      Muscle(name,
             Point4("a", "/bodyset/thigh", "0 0 0") +
                 Point4("b", "/bodyset/shank", "0 " + force + "e-4 0")),
      "<GeometryPath",
      "<max_isometric_force>" + force +
          "</max_isometric_force><!-- </Muscle> -->"
          "<tendon_slack_length>0.25</tendon_slack_length><GeometryPath");
}

std::string LegModel(const std::string& second = MuscleWith("vastus_b",
                                                            "400")) {
  return Replaced(
      Model4(Joint4("PinJoint", "knee"),
             "",
             MuscleWith("vastus_a", "1200") + "\n  " + second + "\n  " +
                 MuscleWith("rectus", "700")),
      "</Model>",
      "<groups><ObjectGroup name=\"front\"><members>rectus vastus_b "
      "vastus_a</members></ObjectGroup></groups></Model>");
}

// Two bands, of 3 and 1 fibres, of a muscle with two lines.
RunPaths PathsOfBands(Model model) {
  RunPaths paths;
  paths.model = std::move(model);
  for (const int band : {1, 2}) {
    MeasuredPath path;
    path.name = "vastus_" + std::to_string(band);
    path.fibres = band == 1 ? std::vector<int>{0, 1, 2} : std::vector<int>{3};
    path.share = band == 1 ? 0.75 : 0.25;
    path.replaces = {"vastus_a", "vastus_b"};
    path.nearest = band == 1 ? "vastus_b" : "vastus_a";
    path.longer = band == 1 ? 20 : -500;
    paths.paths.push_back(path);
  }
  MeasuredPath line;
  line.name = line.nearest = "rectus";
  line.replaces = {"rectus"};
  paths.paths.push_back(line);
  return paths;
}

TEST(OsimBands, ShareTheForceOfTheMusclesThatTheyReplace) {
  const auto bands =
      BandMusclesOf(PathsOfBands(ReadModel(Written("leg.osim", LegModel()))));
  ASSERT_EQ(bands.size(), 2u);
  EXPECT_EQ(bands[0].force, 1200);
  EXPECT_EQ(bands[1].force, 400);
  // A longer band has a longer tendon, so that its fibres are as long.
  EXPECT_EQ(bands[0].tendon, 270);
  EXPECT_EQ(bands[1].tendon, kShortestTendon);
}

TEST(OsimBands, AreMusclesOfTheModel) {
  const std::string before = LegModel();
  const auto bands =
      BandMusclesOf(PathsOfBands(ReadModel(Written("leg.osim", before))));
  const std::string text = WithBandMuscles(before, "leg.osim", bands);
  const Model model = ReadModel(Written("bands.osim", text));
  std::vector<std::string> names;
  for (const auto& muscle : model.muscles) names.push_back(muscle.name);
  EXPECT_THAT(names, ElementsAre("vastus_1", "vastus_2", "rectus"));
  const ModelDynamics dynamics = DynamicsOf(model);
  EXPECT_EQ(dynamics.muscles.at("vastus_1").force, 1200);
  EXPECT_NEAR(dynamics.muscles.at("vastus_1").tendon, 270, 1e-9);
  EXPECT_EQ(dynamics.muscles.at("rectus").force, 700);
  // Each has the path of the muscle that it is a copy of.
  EXPECT_THAT(text, HasSubstr("0 400e-4 0"));
  EXPECT_THAT(text, HasSubstr("<members>rectus vastus_1 vastus_2</members>"));
  EXPECT_THAT(text, Not(HasSubstr("vastus_a")));
  // All before and after the muscles stays.
  const size_t first = before.find("vastus_a");
  EXPECT_EQ(text.substr(0, first), before.substr(0, first));
  EXPECT_THAT(text, HasSubstr(MuscleWith("rectus", "700")));
}

TEST(OsimBands, NeedAForceAndATendon) {
  const Model model = ReadModel(
      Written("leg.osim",
              LegModel(Muscle("vastus_b",
                              Point4("a", "/bodyset/thigh", "0 0 0") +
                                  Point4("b", "/bodyset/shank", "0 0 0")))));
  ExpectInputError([&] { BandMusclesOf(PathsOfBands(model)); },
                   {"leg.osim: muscle \"vastus_b\"", "max_isometric_force"});
}

TEST(OsimBands, HaveNamesOfTheirOwn) {
  BandMuscle band;
  band.name = "rectus";
  band.like = "vastus_a";
  band.replaces = {"vastus_a"};
  ExpectInputError([&] { WithBandMuscles(LegModel(), "leg.osim", {band}); },
                   {"leg.osim", "named \"rectus\""});
}

}  // namespace
}  // namespace musclewarp
