// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// What musclewarp-deform makes of a small scene that has something wrong.
class BadInput : public ::testing::Test {
 protected:
  BadInput() : dir_(TestTempDir()) {
    TriangleSoup bone = Icosphere(10, 1);
    bone.points.rowwise() += Eigen::RowVector3d(40, 0, 30);
    WriteTriangleSoup(dir_ + "/muscle.ply", Spindle(12, 60, 3));
    WriteTriangleSoup(dir_ + "/bone.ply", bone);
    scene_ = Json::parse(R"({"name": "spindle", "units": "mm",
      "muscles": [{"name": "muscle", "mesh": "muscle.ply", "lines":
        [{"name": "line", "rest": [[0,0,-55],[0,0,0],[0,0,55]],
          "bodies": ["bone", "bone", "bone"]}]}],
      "bones": [{"name": "bone", "mesh": "bone.ply", "body": "bone"}],
      "poses": [{"name": "rest"}, {"name": "bent", "bodies":
        {"bone": [[1,0,0,3],[0,1,0,0],[0,0,1,0],[0,0,0,1]]}}]})");
  }

  ProgramRun Run(const std::string& flags = "") {
    WriteTextAtomically(dir_ + "/scene.json", scene_.dump());
    return RunCommandLine(MUSCLEWARP_DEFORM,
                          "--contact=none --scene=" + dir_ +
                              "/scene.json --out=" + dir_ + "/out " + flags);
  }

  // Exit code 2, all words in the message, and nothing written.
  void ExpectRefused(const std::vector<std::string>& words,
                     const std::string& flags = "") {
    const ProgramRun run = Run(flags);
    EXPECT_EQ(run.exit_code, 2) << flags << run.out << run.errors;
    for (const std::string& word : words) {
      EXPECT_THAT(run.errors, HasSubstr(word)) << flags;
    }
    EXPECT_FALSE(fs::exists(dir_ + "/out")) << flags;
  }

  // The same for the scene with the value at a JSON pointer replaced; the
  // scene is as before afterwards.
  void ExpectRefusedWith(const std::string& pointer,
                         const Json& value,
                         const std::vector<std::string>& words) {
    const Json good = scene_;
    scene_[Json::json_pointer(pointer)] = value;
    ExpectRefused(words);
    scene_ = good;
  }

  const std::string dir_;
  Json scene_;
};

TEST_F(BadInput, CoordinatesBeyondTheLimitAreRefusedByTheirField) {
  ExpectRefusedWith("/muscles/0/lines/0/rest/2/2",
                    1e308,
                    {"scene.json: muscles[0].lines[0].rest[2][2]",
                     "1e+308",
                     "allowed: -1e7 to 1e7 mm"});
  ExpectRefusedWith("/poses/1/bodies/bone/0/3",
                    -2e7,
                    {"poses[1].bodies.bone[0][3]", "1e7 mm"});
  ExpectRefusedWith("/poses/1/lines",
                    {{"line", {{0, 0, 1}, {0, 1e20, 2}, {0, 0, 3}}}},
                    {"poses[1].lines.line[1][1]", "1e+20"});
}

TEST_F(BadInput, MeshesBeyondTheLimitAreRefusedByTheirPoint) {
  TriangleSoup mesh = Spindle(12, 60, 3);
  for (const double value : {1e308, 1e8}) {
    mesh.points(5, 1) = value;
    WriteTriangleSoup(dir_ + "/muscle.ply", mesh);
    ExpectRefused({"muscle.ply: point 5", "allowed: -1e7 to 1e7 mm"});
  }
  WriteTriangleSoup(dir_ + "/muscle.ply", Spindle(12, 60, 3));
  mesh = Icosphere(10, 1);
  mesh.points(7, 2) = -1e200;
  WriteTriangleSoup(dir_ + "/bone.ply", mesh);
  ExpectRefused({"bone.ply: point 7", "1e7"}, "--contact=certified");
}

TEST_F(BadInput, NumbersThatNoDoubleHoldsAreRefused) {
  std::string text = scene_.dump();
  text.replace(text.find("-55"), 3, "1e999");
  WriteTextAtomically(dir_ + "/scene.json", text);
  const ProgramRun run =
      RunCommandLine(MUSCLEWARP_DEFORM,
                     "--scene=" + dir_ + "/scene.json --out=" + dir_ + "/out");
  EXPECT_EQ(run.exit_code, 2) << run.errors;
  EXPECT_THAT(run.errors, AllOf(HasSubstr("scene.json"), HasSubstr("large")));
}

TEST_F(BadInput, NamesThatCannotBeWrittenAreRefusedBeforeAnythingIs) {
  const std::string long_name(201, 'm');
  for (const char* pointer : {"/muscles/0/name", "/bones/0/name"}) {
    ExpectRefusedWith(pointer, "a\nb", {"scene.json", R"("a\nb")", "control"});
    ExpectRefusedWith(pointer, std::string("a\0b", 3), {R"("a\u0000b")"});
    ExpectRefusedWith(pointer, long_name, {"201 bytes", "at most 200"});
    ExpectRefusedWith(pointer, "a/b", {"\"a/b\"", "file name"});
    ExpectRefusedWith(pointer, ".resume", {"\".resume\"", "dot"});
    ExpectRefusedWith(pointer, "m ", {"\"m \"", "blank"});
  }
  ExpectRefusedWith("/muscles/0/lines/0/name", "l\t1", {R"("l\t1")"});
  ExpectRefusedWith("/poses/1/name", "bent\r", {R"("bent\r")"});
}

TEST_F(BadInput, NamesOfTwoHundredBytesAreWritten) {
  const std::string name(200, 'm');
  scene_["muscles"][0]["name"] = name;
  const ProgramRun run = Run("--frames=0");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_TRUE(fs::exists(dir_ + "/out/frame_0000/" + name + ".ply"));
}

TEST_F(BadInput, ALineFarOffItsMuscleIsWarnedOf) {
  scene_["muscles"][0]["lines"][0]["rest"][2] = {0, 0, 1e6};
  const ProgramRun run = Run("--frames=0");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(run.errors,
              AllOf(HasSubstr("point 2 of line line"),
                    HasSubstr("999940 mm"),
                    HasSubstr("muscle muscle")));
}

TEST_F(BadInput, MessagesNameTheSceneFileOnce) {
  scene_["muscles"][0]["lines"][0]["bodies"][0] = "tail";
  const ProgramRun run = Run();
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.errors.find("scene.json"), run.errors.rfind("scene.json"))
      << run.errors;
}

TEST_F(BadInput, BodiesWithoutABoneGuideLinesAsThoseWithOneDo) {
  // Attachments and the ends of fibres are found on bones.
  const std::string flags = "--frames=1 --attachments=none --bending_weight=0";
  ASSERT_EQ(Run(flags).exit_code, 0);
  const std::string file = dir_ + "/out/frame_0001/muscle.ply";
  const std::string with_bone = FileText(file);
  scene_["bones"] = Json::array();
  const ProgramRun run = Run(flags);
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(FileText(file), with_bone);
}

TEST_F(BadInput, FlagsThatAreNotAllowedAreRefusedByTheirName) {
  struct Case {
    const char* flag;
    const char* value;
    const char* allowed;
  };
  const std::vector<Case> cases = {
      {"max_hole", "-1", "0 or above"},
      {"coarse_vertices", "5", "20 to 5000"},
      {"bone_coarse_vertices", "5", "20 to 5000"},
      {"sample_spacing", "0", "0.01 or above, mm"},
      {"skeleton_weight", "inf", "above 0, at most 1e6"},
      {"attachment_weight", "-1", "0 to 1e6"},
      {"auto_lines", "0", "1 or above"},
      {"max_iterations", "0", "1 or above"},
      {"threads", "-1", "0 to 1024"},
      {"fibres", "-1", "0 or above"},
      {"solver", "newton", "ceres, reference"},
      {"contact", "soft", "certified, paper, none"},
      {"contact_level", "middle", "coarse, fine"},
      {"remake", "always", "auto, never"},
      {"attachments", "all", "auto, scene, none"},
      {"format", "doc", "ply, obj, vtp"},
      {"motion_in_degrees", "perhaps", "yes, no"},
      {"geometry", "nowhere", "folders that exist"},
      {"frames", "2:9", "frames 0 to 1"}};
  for (const Case& bad : cases) {
    const std::string flag = std::string("--") + bad.flag;
    ExpectRefused({flag, bad.value, bad.allowed}, flag + "=" + bad.value);
  }
  ExpectRefused({"--model", "--list"}, "--model=leg.osim");
  ExpectRefused({"--list", "--model=FILE"}, "--list");
  // Values of another type, by the library that reads flags.
  ExpectRefused({"seed", "-1"}, "--seed=-1");
  ExpectRefused({"body_twist", "maybe"}, "--body_twist=maybe");
}

TEST_F(BadInput, FlagsAreCheckedBeforeAnythingIsRead) {
  const ProgramRun run = RunCommandLine(
      MUSCLEWARP_DEFORM,
      "--scene=" + dir_ + "/none.json --out=" + dir_ + "/out --max_hole=-1");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(
      run.errors,
      AllOf(HasSubstr("--max_hole: is -1;"), Not(HasSubstr("none.json"))));
}

TEST_F(BadInput, ALogOfAnotherVersionIsRefusedAndKept) {
  fs::create_directories(dir_ + "/out/.resume");
  WriteTextAtomically(dir_ + "/out/.resume/inputs", "0123456789abcdef");
  const ProgramRun run = Run("--resume");
  EXPECT_EQ(run.exit_code, 2) << run.out;
  EXPECT_THAT(run.errors,
              AllOf(HasSubstr(".resume/inputs"),
                    HasSubstr("another version"),
                    HasSubstr("run without --resume")));
  EXPECT_TRUE(fs::exists(dir_ + "/out/.resume/inputs"));
  EXPECT_FALSE(fs::exists(dir_ + "/out/report.json"));
}

}  // namespace
}  // namespace musclewarp
