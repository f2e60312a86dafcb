// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/separate_command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/program/program.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

// The volume is restored to 1e-8 in each step.
constexpr double kVolumeTolerance = 1e-6;

// Meshes that need not move are carried by their hulls, to rounding.
constexpr double kUnmoved = 1e-6;  // mm

// Writes two ellipsoids that overlap by 3 mm, and a box that one of them enters
// by 2 mm, to a.ply, b.ply and box.ply in `dir`.
void WriteOverlappingMeshes(const std::string& dir) {
  const TriangleSoup spindle = Spindle(12, 40, 2);
  WriteTriangleSoup(dir + "/a.ply", spindle);
  WriteTriangleSoup(dir + "/b.ply", MovedBy(spindle, {21, 0, 0}));
  WriteTriangleSoup(dir + "/box.ply", MovedBy(Box(10, 60, 60), {-15, 0, 0}));
}

// Runs the command on files in `dir`, given without their extension.
int Separate(const std::string& dir,
             const std::vector<std::string>& names,
             const SeparateOptions& options,
             std::string* screen = nullptr) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    files.push_back(dir + "/" + name + ".ply");
  }
  std::ostringstream out;
  const int exit_code = SeparateCommand(files, options, out);
  if (screen) *screen = out.str();
  return exit_code;
}

// With one thread: more are slower on small meshes, by far where other programs
// run.
SeparateOptions WithoutBones(const std::string& dir, const std::string& out) {
  SeparateOptions options;
  options.out = dir + "/" + out;
  options.threads = 1;
  return options;
}

SeparateOptions WithBox(const std::string& dir, const std::string& out) {
  SeparateOptions options = WithoutBones(dir, out);
  options.bone = dir + "/box.ply";
  return options;
}

void ExpectApart(const std::vector<std::string>& files) {
  for (size_t i = 0; i < files.size(); ++i) {
    for (size_t k = i + 1; k < files.size(); ++k) {
      const SearchableMesh a(ReadTriangleSoup(files[i]));
      const SearchableMesh b(ReadTriangleSoup(files[k]));
      EXPECT_TRUE(IntersectMeshes(a, b).IsEmpty()) << files[i] << files[k];
    }
  }
}

double VolumeOf(const std::string& file) {
  const TriangleSoup soup = ReadTriangleSoup(file);
  return SignedVolume(soup.points, soup.triangles);
}

void ExpectSeparationRefused(const std::vector<std::string>& files,
                             const SeparateOptions& options,
                             const std::vector<std::string>& words) {
  std::ostringstream screen;
  ExpectInputError([&] { SeparateCommand(files, options, screen); }, words);
  EXPECT_FALSE(!options.out.empty() && fs::exists(options.out));
}

}  // namespace

TEST(SeparateCommand, OverlappingMeshesComeOutApartWithTheirVolumes) {
  const std::string dir = TestTempDir(), out = dir + "/out";
  WriteOverlappingMeshes(dir);
  SeparateOptions options = WithBox(dir, "out");
  options.json = true;
  std::string screen;
  ASSERT_EQ(Separate(dir, {"a", "b"}, options, &screen), kExitUsable) << screen;
  ExpectApart({out + "/a.ply", out + "/b.ply", out + "/box.ply"});
  for (const char* name : {"/a.ply", "/b.ply"}) {
    EXPECT_NEAR(
        VolumeOf(out + name) / VolumeOf(dir + name), 1, kVolumeTolerance);
  }
  EXPECT_EQ(FileText(out + "/box.ply"), FileText(dir + "/box.ply"));

  const Json json = Json::parse(FileText(out + "/separation.json"));
  EXPECT_GT(json["before"]["triangle_pairs"], 0);
  EXPECT_NEAR(json["before"]["max_depth_mm"], 3, 0.1);
  EXPECT_EQ(json["after"]["triangle_pairs"], 0);
  EXPECT_EQ(json["after"]["vertices_inside"], 0);
  EXPECT_GE(json["smallest_gap_mm"], options.gap);
  EXPECT_TRUE(json["shortcomings"].empty());
  ASSERT_EQ(json["muscles"].size(), 2u);
  for (const Json& mesh : json["muscles"]) {
    EXPECT_NEAR(mesh["volume_ratio"], 1, kVolumeTolerance);
    EXPECT_GT(mesh["max_displacement_mm"], mesh["mean_displacement_mm"]);
    EXPECT_EQ(mesh["self_pairs"], 0);
    EXPECT_TRUE(mesh["remade"].is_null());
  }
  EXPECT_EQ(json["bones"][0]["name"], "box");
  EXPECT_THAT(screen, HasSubstr(" before, 0 after\n"));
}

TEST(SeparateCommand, TheOrderOfFilesDoesNotMatter) {
  const std::string dir = TestTempDir();
  WriteOverlappingMeshes(dir);
  Separate(dir, {"a", "b"}, WithBox(dir, "ab"));
  Separate(dir, {"b", "a"}, WithBox(dir, "ba"));
  for (const char* name : {"/a.ply", "/b.ply", "/box.ply"}) {
    EXPECT_EQ(FileText(dir + "/ab" + name), FileText(dir + "/ba" + name));
  }
}

TEST(SeparateCommand, NeedsNoBones) {
  const std::string dir = TestTempDir();
  WriteOverlappingMeshes(dir);
  SeparateOptions options = WithoutBones(dir, "out");
  options.format = "obj,ply";
  options.gap = 0.3;
  EXPECT_EQ(Separate(dir, {"a", "b", "box"}, options), kExitUsable);
  ExpectApart({dir + "/out/a.obj", dir + "/out/b.ply", dir + "/out/box.obj"});
}

TEST(SeparateCommand, MeshesThatDoNotOverlapStay) {
  const std::string dir = TestTempDir();
  WriteOverlappingMeshes(dir);
  const TriangleSoup spindle = ReadTriangleSoup(dir + "/a.ply");
  WriteTriangleSoup(dir + "/a.ply", MovedBy(spindle, {3, 0, 0}));
  WriteTriangleSoup(dir + "/b.ply", MovedBy(spindle, {28, 0, 0}));
  std::string screen;
  EXPECT_EQ(Separate(dir, {"a", "b"}, WithBox(dir, "out"), &screen),
            kExitUsable);
  EXPECT_THAT(screen, HasSubstr("no meshes cross\n"));
  for (const char* name : {"/a.ply", "/b.ply"}) {
    const TriangleSoup before = ReadTriangleSoup(dir + name);
    const TriangleSoup after = ReadTriangleSoup(dir + "/out" + name);
    ASSERT_EQ(after.triangles, before.triangles);
    EXPECT_LT((after.points - before.points).rowwise().norm().maxCoeff(),
              kUnmoved);
  }
}

// The end of an ellipsoid surrounds a bone that is thinner.
TEST(SeparateCommand, AMeshWithAnEndAroundABoneIsMadeAnew) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/around.ply", Spindle(6, 30, 2));
  WriteTriangleSoup(dir + "/box.ply", MovedBy(Box(8, 8, 30), {0, 0, 26}));
  SeparateOptions options = WithBox(dir, "out");
  options.json = true;
  std::string screen;
  EXPECT_EQ(Separate(dir, {"around"}, options, &screen), kExitUsable) << screen;
  EXPECT_THAT(screen, HasSubstr("made anew"));
  ExpectApart({dir + "/out/around.ply", dir + "/out/box.ply"});
  const Json json = Json::parse(FileText(dir + "/out/separation.json"));
  const Json& mesh = json["muscles"][0];
  EXPECT_EQ(mesh["volume_before_mm3"], mesh["remade"]["volume_before_mm3"]);
  // What the box cuts off comes back beside it, to half a per cent, but for
  // what slivers take.
  EXPECT_NEAR(mesh["volume_ratio"], 1, 0.01);
  EXPECT_NEAR(mesh["volume_error"], 0, kVolumeTolerance);
  EXPECT_GT(json["before"]["triangle_pairs"], 0);
}

TEST(SeparateCommand, RefusesBadFiles) {
  const std::string dir = TestTempDir();
  WriteOverlappingMeshes(dir);
  fs::create_directories(dir + "/more");
  WriteTriangleSoup(dir + "/more/a.obj", UnitTetrahedron());
  WriteTextAtomically(dir + "/notes.txt", "no mesh\n");
  WriteTextAtomically(dir + "/torn.off", "OFF\n4 4 0\n0 0 0\n");
  const std::string a = dir + "/a.ply";
  const SeparateOptions options = WithBox(dir, "out");
  ExpectSeparationRefused({}, options, {"files: none given"});
  ExpectSeparationRefused({dir + "/none.ply"}, options, {"none.ply"});
  ExpectSeparationRefused({a, dir + "/notes.txt"}, options, {"notes.txt"});
  ExpectSeparationRefused({dir + "/torn.off", a}, options, {"torn.off"});
  ExpectSeparationRefused({a, dir + "/more/a.obj"},
                          options,
                          {dir + "/more/a.obj: has the name \"a\"", a});
  ExpectSeparationRefused(
      {a, dir + "/box.ply"}, options, {"has the name \"box\""});
}

TEST(SeparateCommand, RefusesBadOptions) {
  const std::string dir = TestTempDir();
  WriteOverlappingMeshes(dir);
  const std::vector<std::string> files = {dir + "/a.ply"};
  SeparateOptions options = WithBox(dir, "out");
  options.gap = 0.6;
  ExpectSeparationRefused(files, options, {"--gap: is 0.6", "at most 0.5"});
  options.gap = 0;
  ExpectSeparationRefused(files, options, {"--gap: is 0", "above 0"});
  options = WithBox(dir, "out");
  options.edge = 200;
  ExpectSeparationRefused(files, options, {"--edge: is 200", "to 100, mm"});
  options = WithBox(dir, "out");
  options.bone = "," + dir + "/box.ply";
  ExpectSeparationRefused(files, options, {"--bone", "comma"});
  options = WithBox(dir, "out");
  options.out.clear();
  ExpectSeparationRefused(files, options, {"--out: is missing"});
}

TEST(SeparateCommand, DoesNotReplaceItsInput) {
  const std::string dir = TestTempDir();
  WriteOverlappingMeshes(dir);
  const std::string before = FileText(dir + "/a.ply");
  std::ostringstream screen;
  ExpectInputError(
      [&] { SeparateCommand({dir + "/a.ply"}, WithBox(dir, "."), screen); },
      {"--out=", "box.ply", "would be replaced"});
  EXPECT_EQ(FileText(dir + "/a.ply"), before);
}

TEST(SeparateCommand, RefusesAMeshInsideABoneUnderTheNameOfTheMesh) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/box.ply", Box(60, 60, 60));
  WriteTriangleSoup(dir + "/inside.ply", Icosphere(10, 2));
  SeparateOptions options = WithBox(dir, "out");
  ExpectSeparationRefused({dir + "/inside.ply"}, options, {"inside"});
  options.remake = "never";
  ExpectSeparationRefused(
      {dir + "/inside.ply"}, options, {"cannot be separated", "--remake=auto"});
}

TEST(SeparateProgram, TakesItsFlags) {
  const std::string dir = TestTempDir();
  WriteOverlappingMeshes(dir);
  const std::string flags = "--out=" + dir + "/out " + dir + "/a.ply " + dir +
                            "/b.ply --bone=" + dir + "/box.ply --threads=1";
  ProgramRun run = RunCommandLine(MUSCLEWARP_SEPARATE, flags + " --format=stl");
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_THAT(run.errors,
              AllOf(HasSubstr("musclewarp-separate: --format=stl"),
                    HasSubstr("allowed: ply, obj, vtp")));
  run = RunCommandLine(MUSCLEWARP_SEPARATE, flags + " --remake=often");
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_FALSE(fs::exists(dir + "/out"));
  run = RunCommandLine(MUSCLEWARP_SEPARATE, flags + " --json --gap=0.2");
  EXPECT_EQ(run.exit_code, kExitUsable) << run.errors;
  EXPECT_EQ(Json::parse(FileText(dir + "/out/separation.json"))["gap_mm"], 0.2);
}

TEST(SeparateCommand, TheLongestHoleThatIsFilledMayBeSet) {
  const std::string dir = TestTempDir();
  WriteOverlappingMeshes(dir);
  // Without the triangles around a corner: a hole of five or six edges.
  TriangleSoup open = Icosphere(30, 1);
  Triangles rest(0, 3);
  for (const auto& triangle : open.triangles.rowwise()) {
    if ((triangle.array() == 0).any()) continue;
    rest.conservativeResize(rest.rows() + 1, 3);
    rest.bottomRows<1>() = triangle;
  }
  open.triangles = rest;
  WriteTriangleSoup(dir + "/open.ply", MovedBy(open, {200, 0, 0}));
  SeparateOptions options = WithoutBones(dir, "out");
  const std::vector<std::string> files = {dir + "/open.ply", dir + "/a.ply"};
  ExpectSeparationRefused(files, options, {"open.ply", "--max_hole"});
  options.max_hole = -1;
  ExpectSeparationRefused(files, options, {"--max_hole: is -1", "0 or above"});
  options.max_hole = 200;
  EXPECT_EQ(Separate(dir, {"open", "a"}, options), kExitUsable);
}

}  // namespace musclewarp
