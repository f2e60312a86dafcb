// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/run_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "run/written_run.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Makes a file with something in it, and its folders.
void Touch(const std::string& path) {
  fs::create_directories(fs::path(path).parent_path());
  std::ofstream(path) << "x";
}

TEST(MeshFilesIn, TakesTheMostExactFormatOfAMesh) {
  const std::string dir = TestTempDir();
  for (const char* name :
       {"a.stl", "a.ply", "a.obj", "b.stl", "b.off", "c.vtk"}) {
    Touch(dir + "/" + name);
  }
  for (const char* other : {"report.json", "lines", "frame_0000/d.ply"}) {
    Touch(dir + "/" + other);
  }
  EXPECT_EQ(MeshFilesIn(dir),
            (MeshFiles{{"a", dir + "/a.ply"},
                       {"b", dir + "/b.off"},
                       {"c", dir + "/c.vtk"}}));
}

TEST(MeshFilesIn, AFolderWithoutMeshesIsRefused) {
  const std::string dir = TestTempDir();
  ExpectInputError([&] { MeshFilesIn(dir); }, {dir, "holds no mesh"});
  ExpectInputError([&] { MeshFilesIn(dir + "/none"); },
                   {dir + "/none", "no such folder"});
}

TEST(FrameFilesIn, HasBonesThatAreWrittenOnceWhereTheyAreInTheFrame) {
  const WrittenRun written = WriteRun(TestTempDir());
  const std::string folder = written.dir + "/frame_0001";
  const FrameFiles every = FrameFilesIn(folder);
  EXPECT_TRUE(every.bones_from_rest.empty());
  const TriangleSoup bone = ReadMeshOfFrame(every, "bone");
  EXPECT_EQ(bone.points, written.bone_frames[1]);
  written.KeepBonesOnce();
  for (const std::string& name : {folder, folder + "/"}) {
    const FrameFiles once = FrameFilesIn(name);
    EXPECT_EQ(once.meshes.at("bone"), written.dir + "/rest/bone.ply");
    const TriangleSoup moved = ReadMeshOfFrame(once, "bone");
    EXPECT_EQ(moved.points, bone.points);
    EXPECT_EQ(moved.triangles, bone.triangles);
    EXPECT_EQ(ReadMeshOfFrame(once, "muscle").points, written.muscle.points);
  }
  fs::remove(written.dir + "/rest/bone.ply");
  ExpectInputError([&] { FrameFilesIn(folder); },
                   {folder + "/bones.json", "\"bone\"", "rest folder"});
}

TEST(FindRunFiles, ReadsNamesFromTheReport) {
  const WrittenRun written = WriteRun(TestTempDir());
  const RunFiles run = FindRunFiles(written.dir, "0,1");
  EXPECT_TRUE(run.has_report);
  EXPECT_EQ(run.muscles, std::vector<std::string>{"muscle"});
  EXPECT_EQ(run.axes, "ASR");
  EXPECT_EQ(run.side, "left");
  ASSERT_EQ(run.frames.size(), 2u);
  EXPECT_EQ(run.frames[1].name, "hip 10 degrees");  // what its motion moves
  EXPECT_EQ(run.frames[1].meshes, MeshFilesIn(written.dir + "/frame_0001"));
}

TEST(FindRunFiles, KeepsTheOrderThatIsAskedFor) {
  const std::string dir = TestTempDir();
  for (const char* name : {"frame_0000", "frame_0001", "frame_0007"}) {
    Touch(dir + "/" + name + "/a.ply");
  }
  const RunFiles run = FindRunFiles(dir, "last,0,1,0");
  EXPECT_FALSE(run.has_report);
  ASSERT_EQ(run.frames.size(), 4u);
  for (const auto& [i, folder] :
       {std::pair(0, "7"), {1, "0"}, {2, "1"}, {3, "0"}}) {
    EXPECT_EQ(run.frames[i].meshes.at("a"),
              dir + "/frame_000" + folder + "/a.ply");
  }
}

TEST(FindRunFiles, AFolderOfMeshesIsAFrame) {
  const std::string dir = TestTempDir();
  Touch(dir + "/a.ply");
  const RunFiles run = FindRunFiles(dir, "last");
  ASSERT_EQ(run.frames.size(), 1u);
  EXPECT_EQ(run.frames[0].name, "");
  EXPECT_EQ(run.frames[0].meshes, MeshFilesIn(dir));
}

TEST(FindRunFiles, MissingFramesAreNamed) {
  const std::string dir = TestTempDir();
  Touch(dir + "/frame_0002/a.ply");
  Touch(dir + "/frame_0005/a.ply");
  ExpectInputError([&] { FindRunFiles(dir, "2,3"); },
                   {"frames", "'3' is not a frame", "from 2 to 5"});
  ExpectInputError([&] { FindRunFiles(dir, "first"); }, {"frames", "'first'"});
  ExpectInputError([&] { FindRunFiles(dir, ""); },
                   {"frames", "names no frame"});
  ExpectInputError([&] { FindRunFiles(dir + "/none", "0"); },
                   {dir + "/none", "in"});
}

}  // namespace
}  // namespace musclewarp
