// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/obj_io.h"
#include "musclewarp/program/program.h"
#include "support/meshes.h"
#include "support/temp_dir.h"
#include "tools/run_program.h"

// Mesh files of several closed surfaces or named parts.

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;

// Volumes are restored to 1e-8 in each step.
constexpr double kPieceVolumeTolerance = 1e-6;

TriangleSoup MadeMedius() { return Spindle(12, 40, 2); }
TriangleSoup MadeMinimus() { return MovedBy(Spindle(9, 30, 2), {30, 0, 0}); }

// Two muscles apart, as the objects "gluteus medius" and "minimus" of an .obj.
std::string WriteTwoObjects(const std::string& dir) {
  const TriangleSoup both = Together(MadeMedius(), MadeMinimus());
  std::string text = ObjBytes(both);
  size_t face = text.find("f ");
  text.insert(face, "o gluteus medius\n");
  for (Eigen::Index f = 0; f <= MadeMedius().triangles.rows(); ++f) {
    face = text.find("\nf ", face + 1);
  }
  text.insert(face + 1, "o minimus\n");
  const std::string file = dir + "/muscles.obj";
  WriteTextAtomically(file, text);
  return file;
}

ProgramRun RunSeparate(const std::string& arguments) {
  return RunCommandLine(MUSCLEWARP_SEPARATE, "--threads=1 " + arguments);
}

double VolumeOfMesh(const TriangleSoup& mesh) {
  return SignedVolume(mesh.points, mesh.triangles);
}

void ExpectVolume(const std::string& file, const TriangleSoup& mesh) {
  EXPECT_NEAR(VolumeOfMesh(ReadTriangleSoup(file)) / VolumeOfMesh(mesh),
              1,
              kPieceVolumeTolerance)
      << file;
}

}  // namespace

TEST(SeparatePieces, AFileOfTwoObjectsIsRefusedBeforeAnythingIsWritten) {
  const std::string dir = TestTempDir(), out = dir + "/out";
  const ProgramRun run =
      RunSeparate("--out=" + out + " " + WriteTwoObjects(dir));
  EXPECT_EQ(run.exit_code, kExitBadInput);
  EXPECT_THAT(run.errors,
              AllOf(HasSubstr("has 2 objects: gluteus medius, minimus"),
                    HasSubstr("muscles.obj#gluteus medius\""),
                    HasSubstr("--pieces=all")));
  EXPECT_FALSE(fs::exists(out));
}

TEST(SeparatePieces, ObjectsAreNamedOnTheCommandLine) {
  const std::string dir = TestTempDir(), out = dir + "/out";
  const std::string file = WriteTwoObjects(dir);
  const ProgramRun run = RunSeparate("--json --out=" + out + " '" + file +
                                     "#gluteus medius' " + file + "#minimus");
  ASSERT_EQ(run.exit_code, kExitUsable) << run.out << run.errors;
  ExpectVolume(out + "/gluteus medius.ply", MadeMedius());
  ExpectVolume(out + "/minimus.ply", MadeMinimus());
  const Json json = Json::parse(FileText(out + "/separation.json"));
  EXPECT_EQ(json["muscles"][0]["mesh"], "../muscles.obj#gluteus medius");

  const ProgramRun check =
      RunCommandLine(MUSCLEWARP_CHECK, file + "#minimus " + file + "#maximus");
  EXPECT_EQ(check.exit_code, kExitBadInput);
  EXPECT_THAT(check.errors, HasSubstr("allowed: gluteus medius, minimus"));
}

TEST(SeparatePieces, APartMayBeABone) {
  const std::string dir = TestTempDir(), out = dir + "/out";
  const std::string file = WriteTwoObjects(dir);
  const ProgramRun run = RunSeparate("--out=" + out + " --bone=" + file +
                                     "#minimus '" + file + "#gluteus medius'");
  ASSERT_EQ(run.exit_code, kExitUsable) << run.out << run.errors;
  EXPECT_EQ(ReadTriangleSoup(out + "/minimus.ply").points,
            MadeMinimus().points);
}

TEST(SeparatePieces, AllPiecesBecomeMeshes) {
  const std::string dir = TestTempDir();
  const std::string objects = WriteTwoObjects(dir), bellies = dir + "/two.ply";
  WriteTriangleSoup(bellies, Together(MadeMinimus(), MadeMedius()));
  ProgramRun run =
      RunSeparate("--pieces=all --out=" + dir + "/named " + objects);
  ASSERT_EQ(run.exit_code, kExitUsable) << run.out << run.errors;
  ExpectVolume(dir + "/named/gluteus medius.ply", MadeMedius());
  ExpectVolume(dir + "/named/minimus.ply", MadeMinimus());
  run = RunSeparate("--pieces=all --out=" + dir + "/numbered " + bellies);
  ASSERT_EQ(run.exit_code, kExitUsable) << run.out << run.errors;
  ExpectVolume(dir + "/numbered/two_1.ply", MadeMedius());
  ExpectVolume(dir + "/numbered/two_2.ply", MadeMinimus());
}

TEST(SeparatePieces, TheLargestAloneIsALoss) {
  const std::string dir = TestTempDir(), file = dir + "/two.ply";
  WriteTriangleSoup(file, Together(MadeMinimus(), MadeMedius()));
  const ProgramRun run = RunSeparate("--out=" + dir + "/out " + file);
  EXPECT_EQ(run.exit_code, kExitNotUsable);
  EXPECT_THAT(run.out, HasSubstr("two"));
  EXPECT_THAT(run.out + run.errors, HasSubstr("--pieces=all"));
  ExpectVolume(dir + "/out/two.ply", MadeMedius());
}

TEST(SeparatePieces, AnOpenPieceCountsAsLost) {
  const std::string dir = TestTempDir(), file = dir + "/two.ply";
  TriangleSoup open = SphereAt({60, 0, 0}, 15, 2);
  open.triangles.conservativeResize(open.triangles.rows() / 2, 3);
  WriteTriangleSoup(file, Together(MadeMedius(), open));
  const ProgramRun run =
      RunSeparate("--pieces=all --max_hole=10 --out=" + dir + "/out " + file);
  EXPECT_EQ(run.exit_code, kExitNotUsable) << run.errors;
  EXPECT_THAT(run.out, HasSubstr("not usable: two:"));
  EXPECT_THAT(run.out + run.errors, HasSubstr("too long to be closed"));
}

TEST(SeparatePieces, AFileOfOnePieceIsReadAsEver) {
  const std::string dir = TestTempDir(), file = dir + "/medius.ply";
  WriteTriangleSoup(file, MadeMedius());
  ASSERT_EQ(RunSeparate("--out=" + dir + "/largest " + file).exit_code, 0);
  ASSERT_EQ(RunSeparate("--pieces=all --out=" + dir + "/all " + file).exit_code,
            0);
  EXPECT_EQ(FileText(dir + "/all/medius.ply"),
            FileText(dir + "/largest/medius.ply"));
}

}  // namespace musclewarp
