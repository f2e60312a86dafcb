// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

Json GoodJson() {
  return Json::parse(R"({
    "name": "one muscle", "units": "mm",
    "muscles": [{"name": "m", "mesh": "m.ply",
      "lines": [{"name": "l", "rest": [[0,0,0],[0,0,9]], "bodies": ["p","f"]}],
      "attachments": [{"body": "f", "points": [[0,0,9]], "radius": 3}]}],
    "bones": [{"name": "pelvis", "mesh": "p.ply", "body": "p"},
              {"name": "femur", "mesh": "f.ply", "body": "f"}],
    "poses": [{"name": "a", "time": 0.5,
      "bodies": {"f": [[1,0,0,0],[0,1,0,0],[0,0,1,7],[0,0,0,1]]},
      "lines": {"l": [[0,0,1],[0,0,8]]}}]})");
}

Scene SceneOf(const Json& json) {
  const std::string path = TestTempDir() + "/scene.json";
  WriteTextAtomically(path, json.dump());
  return ReadScene(path, "");
}

void ExpectFileRefused(const Json& json, std::vector<std::string> words) {
  words.push_back("scene.json");
  ExpectInputError([&] { SceneOf(json); }, words);
}

// The good scene with the value at a JSON pointer replaced.
Json With(const std::string& pointer, const Json& value) {
  Json scene = GoodJson();
  scene[Json::json_pointer(pointer)] = value;
  return scene;
}

Json Without(const std::string& parent, const std::string& key) {
  Json scene = GoodJson();
  scene[Json::json_pointer(parent)].erase(key);
  return scene;
}

}  // namespace

TEST(Scene, ReadsEveryField) {
  const Scene scene = SceneOf(GoodJson());
  EXPECT_EQ(scene.name, "one muscle");
  ASSERT_EQ(scene.muscles.size(), 1u);
  const SceneMuscle& muscle = scene.muscles[0];
  EXPECT_EQ(muscle.name, "m");
  EXPECT_EQ(muscle.mesh_path,
            scene.path.substr(0, scene.path.rfind('/')) + "/m.ply");
  EXPECT_EQ(muscle.lines[0].name, "l");
  EXPECT_EQ(muscle.lines[0].rest(1, 2), 9);
  EXPECT_EQ(muscle.lines[0].bodies[1], "f");
  EXPECT_EQ(muscle.attachments[0].radius, 3);
  EXPECT_EQ(scene.bones[1].body, "f");
  EXPECT_EQ(scene.poses[0].time, 0.5);
  EXPECT_EQ(scene.poses[0].bodies.at("f")(2, 3), 7);
  EXPECT_EQ(scene.poses[0].lines.at("l")(1, 2), 8);
}

// As SECURITY.md says: segmentations and models are where they are.
TEST(Scene, MayNameFilesOutsideOfItsFolder) {
  const Scene beside = SceneOf(With("/muscles/0/mesh", "../others/m.ply"));
  EXPECT_EQ(beside.muscles[0].mesh_path,
            beside.path.substr(0, beside.path.rfind('/')) + "/../others/m.ply");
  const Scene whole = SceneOf(With("/bones/0/mesh", "/data/p.ply"));
  EXPECT_EQ(whole.bones[0].mesh_path, "/data/p.ply");
}

// The same scene in metres: every length is read in that unit, and is mm.
TEST(Scene, UnitsAreThoseOfTheFile) {
  const Scene millimetres = SceneOf(GoodJson());
  const Scene metres = SceneOf(With("/units", "m"));
  const SceneMuscle &a = millimetres.muscles[0], &b = metres.muscles[0];
  EXPECT_EQ(a.mm_per_unit, 1);
  EXPECT_EQ(b.mm_per_unit, 1000);
  EXPECT_EQ(b.lines[0].rest, 1000 * a.lines[0].rest);
  EXPECT_EQ(b.attachments[0].points, 1000 * a.attachments[0].points);
  EXPECT_EQ(b.attachments[0].radius, 1000 * a.attachments[0].radius);
  EXPECT_EQ(metres.bones[0].rest_from_file.diagonal(),
            Eigen::Vector4d(1000, 1000, 1000, 1));
  Eigen::Matrix4d moved = millimetres.poses[0].bodies.at("f");
  moved.topRightCorner<3, 1>() *= 1000;
  EXPECT_EQ(metres.poses[0].bodies.at("f"), moved);
  EXPECT_EQ(metres.poses[0].lines.at("l"),
            1000 * millimetres.poses[0].lines.at("l"));
}

TEST(Scene, PathsFollowTheDataRoot) {
  const std::string path = TestTempDir() + "/scene.json";
  WriteTextAtomically(path, GoodJson().dump());
  EXPECT_EQ(ReadScene(path, "/data").muscles[0].mesh_path, "/data/m.ply");
}

TEST(Scene, APartOfAMeshFileDependsOnTheFile) {
  const Scene scene = SceneOf(With("/muscles/0/mesh", "m.obj#left psoas"));
  EXPECT_EQ(scene.muscles[0].mesh_path, TestTempDir() + "/m.obj#left psoas");
  EXPECT_THAT(scene.files, ::testing::Contains(TestTempDir() + "/m.obj"));
}

TEST(Scene, AMuscleIsOnePiece) {
  EXPECT_NO_THROW(SceneOf(With("/muscles/0/pieces", "largest")));
  ExpectFileRefused(With("/muscles/0/pieces", "all"),
                    {"muscles[0].pieces",
                     "one closed surface",
                     "separation with pieces=all"});
  ExpectFileRefused(With("/muscles/0/pieces", "both"),
                    {"muscles[0].pieces", "\"both\"", "allowed"});
}

TEST(Scene, RefusesWhatIsNotAScene) {
  const std::string path = TestTempDir() + "/scene.json";
  EXPECT_THROW(ReadScene(path, ""), InputError);
  EXPECT_THROW(ReadScene(TestTempDir(), ""), InputError);
  for (const char* text : {"", "{", "[1, 2]", "\"text\"", "{\"name\": 1,}"}) {
    WriteTextAtomically(path, text);
    EXPECT_THROW(ReadScene(path, ""), InputError) << text;
  }
  WriteTextAtomically(path, "{\n\"name\": \"a\",\n\"units\" \"mm\"\n}");
  try {
    ReadScene(path, "");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("line 3"));
  }
}

TEST(Scene, RefusesUnknownMissingAndRepeatedKeys) {
  ExpectFileRefused(With("/muscels", 1), {"muscels", "allowed", "muscles"});
  ExpectFileRefused(With("/muscles/0/colour", 1), {"muscles[0]", "colour"});
  ExpectFileRefused(With("/poses/0/bones", 1), {"poses[0]", "bones"});
  ExpectFileRefused(Without("", "units"), {"units", "missing"});
  ExpectFileRefused(Without("/muscles/0", "mesh"),
                    {"muscles[0].mesh", "missing"});
  const std::string path = TestTempDir() + "/scene.json";
  std::string text = GoodJson().dump();
  text.insert(1, "\"name\": \"first\", ");
  WriteTextAtomically(path, text);
  EXPECT_THROW(ReadScene(path, ""), InputError);
}

TEST(Scene, RefusesWrongTypesAndValues) {
  ExpectFileRefused(With("/name", 5), {"name", "5"});
  ExpectFileRefused(With("/units", "inch"), {"units", "\"inch\"", "mm, cm, m"});
  ExpectFileRefused(With("/axes", "LPX"), {"axes", "\"LPX\"", "LPS"});
  ExpectFileRefused(With("/axes", "LRS"), {"axes", "\"LRS\""});
  ExpectFileRefused(With("/side", "up"), {"side", "\"up\"", "left"});
  ExpectFileRefused(With("/muscles", Json::object()), {"muscles", "array"});
  ExpectFileRefused(With("/muscles", Json::array()), {"muscles", "empty"});
  ExpectFileRefused(With("/poses", Json::array()), {"pose"});
  ExpectFileRefused(With("/muscles/0/lines/0/rest/1", {1, 2}),
                    {"muscles[0].lines[0].rest[1]", "[x, y, z]"});
  ExpectFileRefused(With("/muscles/0/lines/0/rest/1/0", "x"),
                    {"muscles[0].lines[0].rest[1][0]", "number"});
  ExpectFileRefused(With("/muscles/0/attachments/0/radius", -1), {"radius"});
  ExpectFileRefused(With("/poses/0/bodies/f/0/0", 2),
                    {"poses[0].bodies.f", "rigid"});
  ExpectFileRefused(With("/poses/0/bodies/f/3/0", 1),
                    {"poses[0].bodies.f", "0 0 0 1"});
  ExpectFileRefused(With("/model", "a.osim"), {"poses", "model"});
  ExpectFileRefused(With("/motion", "a.mot"), {"motion", "model"});
}

TEST(Scene, RefusesBadLines) {
  ExpectFileRefused(With("/muscles/0/lines/0/rest", {{0, 0, 0}}),
                    {"\"l\"", "1 points", "at least 2"});
  ExpectFileRefused(With("/muscles/0/lines/0/rest", {{0, 0, 1}, {0, 0, 1}}),
                    {"\"l\"", "repeats point 0"});
  ExpectFileRefused(With("/poses/0/lines/l", {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}}),
                    {"\"l\"", "\"a\"", "3 points", "2"});
  ExpectFileRefused(With("/muscles/0/lines/0/bodies", {"p"}),
                    {"1 bodies", "2"});
  ExpectFileRefused(With("/poses/0/lines/other", {{0, 0, 1}, {0, 0, 2}}),
                    {"\"other\"", "no muscle"});
  ExpectFileRefused(With("/muscles/0/lines/0", "glut_med1_r"), {"glut_med1_r"});
}

TEST(Scene, MusclesMayComeWithoutLines) {
  Json scene = GoodJson();
  scene["muscles"][0].erase("lines");
  scene["poses"][0].erase("lines");
  EXPECT_TRUE(SceneOf(scene).muscles[0].lines.empty());
}

TEST(Scene, PosesAreAMotionIfTheirTimesRise) {
  Json scene = GoodJson();
  EXPECT_FALSE(SceneOf(scene).is_motion);
  scene["poses"].push_back({{"name", "b"}, {"time", 0.5}});
  EXPECT_FALSE(SceneOf(scene).is_motion);
  scene["poses"][1]["time"] = 0.6;
  EXPECT_TRUE(SceneOf(scene).is_motion);
}

TEST(Scene, RefusesNamesThatClashOrAreUnknown) {
  ExpectFileRefused(With("/bones/0/name", "m"), {"\"m\"", "twice"});
  ExpectFileRefused(With("/bones/0/name", "a/b"), {"\"a/b\"", "file name"});
  ExpectFileRefused(With("/muscles/0/lines/0/bodies/1", "tibia"),
                    {"\"tibia\"", "p"});
  ExpectFileRefused(With("/muscles/0/attachments/0/body", "tibia"),
                    {"\"tibia\""});
  ExpectFileRefused(
      With("/poses/0/bodies/tibia", GoodJson()["poses"][0]["bodies"]["f"]),
      {"\"tibia\""});
  Json scene = GoodJson();
  scene["poses"].push_back(scene["poses"][0]);
  ExpectFileRefused(scene, {"\"a\"", "twice"});
  scene = GoodJson();
  scene["muscles"][0]["lines"].push_back(scene["muscles"][0]["lines"][0]);
  ExpectFileRefused(scene, {"\"l\"", "twice"});
}

TEST(Scene, TakesAreasFromAnAttachmentsFile) {
  const std::string dir = TestTempDir();
  const std::string areas = dir + "/areas.json";
  const auto read = [&](const Json& json) {
    WriteTextAtomically(dir + "/scene.json", json.dump());
    return ReadScene(dir + "/scene.json", "");
  };
  WriteTextAtomically(areas, R"({"units": "mm", "by": "somebody", "muscles": {
    "m": {"origin": [{"set": "A", "points": [[1,2,3]]},
                     {"set": "B", "points": [[4,5,6],[7,8,9]]}],
          "insertion": [{"points": [[0,0,1]]}], "note": 7},
    "other": {"origin": [{"points": [[0,0,0]]}]}}})");
  Json json = GoodJson();
  json["attachments_file"] = {{"path", "areas.json"},
                              {"bodies", {{"origin", "p"}}},
                              {"radius", 4},
                              {"may_penetrate", true}};
  const Scene scene = read(json);
  const auto& attachments = scene.muscles[0].attachments;
  ASSERT_EQ(attachments.size(), 3u);  // the scene's own comes first
  EXPECT_FALSE(attachments[0].may_penetrate);
  EXPECT_EQ(attachments[2].body, "p");
  EXPECT_EQ(attachments[2].points.rows(), 2);
  EXPECT_EQ(attachments[2].radius, 4);
  EXPECT_TRUE(attachments[2].may_penetrate);
  EXPECT_THAT(scene.files, ::testing::Contains(areas));
  json["attachments_file"]["radius"] = 0;
  ExpectInputError([&] { read(json); },
                   {"scene.json", "attachments_file", "radius", "above 0"});
  json["attachments_file"]["radius"] = 4;
  json["attachments_file"]["bodies"]["origin"] = "tail";
  ExpectInputError([&] { read(json); }, {"scene.json", "tail"});
  json["attachments_file"]["bodies"]["origin"] = "p";
  WriteTextAtomically(areas, R"({"units": "inch", "muscles": {}})");
  ExpectInputError([&] { read(json); }, {"areas.json", "units", "mm"});
}

TEST(Scene, TakesLinesAndPosesFromAPosesFile) {
  const std::string dir = TestTempDir();
  WriteTextAtomically(dir + "/poses.json", R"({"units": "mm", "note": "any",
    "lines": {"l": {"muscle": "m", "rest": [[0,0,0],[0,0,9]]},
              "unused": {"rest": [[0,0,0],[1,0,0]]}},
    "poses": [{"flexion_deg": -10, "thigh":
        [[1,0,0,0],[0,1,0,0],[0,0,1,7],[0,0,0,1]],
      "target": {"l": [[0,0,1],[0,0,8]], "unused": [[0,0,0],[2,0,0]]}}]})");
  Json json = GoodJson();
  json.erase("poses");
  json["poses_file"] = {{"path", "poses.json"},
                        {"bodies", {{"thigh", {"f", "p"}}}}};
  json["muscles"][0]["lines"] = {"l"};
  WriteTextAtomically(dir + "/scene.json", json.dump());
  const Scene scene = ReadScene(dir + "/scene.json", "");
  ASSERT_EQ(scene.poses.size(), 1u);
  EXPECT_EQ(scene.poses[0].name, "flexion_deg_-10");
  EXPECT_EQ(scene.poses[0].coordinates.at("flexion_deg"), -10);
  EXPECT_EQ(scene.poses[0].bodies.at("f")(2, 3), 7);
  EXPECT_EQ(scene.poses[0].bodies.at("p")(2, 3), 7);
  EXPECT_EQ(scene.poses[0].lines.size(), 1u);
  EXPECT_EQ(scene.muscles[0].lines[0].rest(1, 2), 9);

  json["muscles"][0]["lines"] = {"l", "missing"};
  WriteTextAtomically(dir + "/scene.json", json.dump());
  EXPECT_THROW(ReadScene(dir + "/scene.json", ""), InputError);
}

}  // namespace musclewarp
