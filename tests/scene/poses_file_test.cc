// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/poses_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::ElementsAre;

Json GoodFile() {
  return Json::parse(R"({"units": "mm", "made by": "somebody",
    "lines": {"l": {"rest": [[0,0,0],[0,0,9]], "bodies": ["hip", "thigh"]}},
    "poses": [{"name": "bent", "time": 0.5, "flexion": 30, "note": "?",
      "femur": [[1,0,0,0],[0,1,0,0],[0,0,1,7],[0,0,0,1]],
      "target": {"l": [[0,0,1],[0,0,8]]}}]})");
}

PosesFile PosesOf(const Json& json) {
  const std::string path = TestTempDir() + "/poses.json";
  WriteTextAtomically(path, json.dump());
  return ReadPosesFile(path, {{"femur", {"thigh", "shank"}}});
}

TEST(PosesFile, HoldsLinesAndPoses) {
  const PosesFile file = PosesOf(GoodFile());
  const ActionLine& line = file.lines.at("l");
  EXPECT_EQ(line.name, "l");
  EXPECT_EQ(line.rest(1, 2), 9);
  EXPECT_THAT(line.bodies, ElementsAre("hip", "thigh"));
  ASSERT_EQ(file.poses.size(), 1u);
  const ScenePose& pose = file.poses[0];
  EXPECT_EQ(pose.name, "bent");
  EXPECT_EQ(pose.time, 0.5);
  EXPECT_EQ(pose.coordinates.size(), 1u);  // the time is none
  EXPECT_EQ(pose.coordinates.at("flexion"), 30);
  EXPECT_EQ(pose.lines.at("l")(1, 2), 8);
  for (const char* body : {"thigh", "shank"}) {
    EXPECT_EQ(pose.bodies.at(body)(2, 3), 7) << body;
  }
}

TEST(PosesFile, CallsAPoseWithoutNameByItsCoordinates) {
  Json json = GoodFile();
  json["poses"][0].erase("name");
  json["poses"][0]["abduction"] = -2.5;
  EXPECT_EQ(PosesOf(json).poses[0].name, "abduction_-2.5_flexion_30");
  json["poses"][0].erase("abduction");
  json["poses"][0].erase("flexion");
  ExpectInputError([&] { PosesOf(json); },
                   {"poses.json: poses[0]", "\"name\""});
}

TEST(PosesFile, RefusesWhatIsMissingOrOfOtherUnits) {
  Json json = GoodFile();
  json["units"] = "inch";
  ExpectInputError([&] { PosesOf(json); },
                   {"poses.json: units", "allowed: mm"});
  json = GoodFile();
  json["poses"][0].erase("femur");
  ExpectInputError([&] { PosesOf(json); }, {"poses[0].femur: is missing"});
  json = GoodFile();
  json["poses"][0].erase("target");
  ExpectInputError([&] { PosesOf(json); }, {"poses[0].target: is missing"});
}

TEST(PosesFile, RefusesCoordinatesThatAreTooLarge) {
  Json json = GoodFile();
  json["lines"]["l"]["rest"][1][2] = 1e308;
  ExpectInputError([&] { PosesOf(json); },
                   {"lines.l.rest[1][2]: is 1e+308", "1e7"});
  json = GoodFile();
  json["poses"][0]["target"]["l"][0][1] = -1e8;
  ExpectInputError([&] { PosesOf(json); }, {"poses[0].target.l[0][1]", "1e7"});
}

}  // namespace
}  // namespace musclewarp
