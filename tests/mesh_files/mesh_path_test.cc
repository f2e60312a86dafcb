// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_files/mesh_path.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "musclewarp/base/output_file.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/obj_io.h"
#include "support/input_errors.h"
#include "support/meshes.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

void ExpectSplit(const std::string& path,
                 const std::string& file,
                 const std::optional<std::string>& part) {
  const MeshPath split = SplitMeshPath(path);
  EXPECT_EQ(split.file, file) << path;
  EXPECT_EQ(split.part, part) << path;
}

TEST(MeshPath, ThePartFollowsTheFileThatIsThere) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.obj", UnitTetrahedron());
  WriteTriangleSoup(dir + "/b#1.obj", UnitTetrahedron());
  ExpectSplit(dir + "/a.obj", dir + "/a.obj", std::nullopt);
  ExpectSplit(dir + "/a.obj#left psoas", dir + "/a.obj", "left psoas");
  ExpectSplit(dir + "/a.obj#psoas#2", dir + "/a.obj", "psoas#2");
  ExpectSplit(dir + "/a.obj#", dir + "/a.obj", "");
  ExpectSplit(dir + "/b#1.obj", dir + "/b#1.obj", std::nullopt);
  ExpectSplit(dir + "/b#1.obj#x", dir + "/b#1.obj", "x");
}

TEST(MeshPath, AFileThatIsMissingEndsWithItsExtension) {
  ExpectSplit("no/a.obj#b", "no/a.obj", "b");
  ExpectSplit("no/a#1.obj", "no/a#1.obj", std::nullopt);
  ExpectSplit("no/a#1.obj#b", "no/a#1.obj", "b");
}

TEST(MeshPath, AMeshIsCalledAsItsPartOrElseItsFile) {
  EXPECT_EQ(MeshNameOf("no/muscles.obj"), "muscles");
  EXPECT_EQ(MeshNameOf("no/muscles.obj#gluteus"), "gluteus");
  EXPECT_EQ(MeshNameOf("no/muscles.obj# left  gluteus "), "left gluteus");
}

TEST(MeshPath, LeadsFromAFolderOnWithItsPart) {
  const std::string dir = TestTempDir();
  WriteTriangleSoup(dir + "/a.obj", UnitTetrahedron());
  EXPECT_EQ(MeshPathFrom(dir + "/run", dir + "/a.obj#b"), "../a.obj#b");
  EXPECT_EQ(MeshPathFrom(dir, dir + "/a.obj"), "a.obj");
}

TEST(MeshPath, IsReadLikeAFile) {
  const std::string dir = TestTempDir();
  const std::string file = dir + "/two.obj", hash = dir + "/two.obj#b";
  WriteTextAtomically(file,
                      "o a\n" + ObjBytes(UnitTetrahedron()) +
                          "o b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n");
  EXPECT_EQ(ReadTriangleSoup(file).triangles.rows(), 5);
  const TriangleSoup part = ReadTriangleSoup(hash);
  EXPECT_EQ(part.triangles.rows(), 1);
  EXPECT_EQ(part.points.rows(), 3);
  ExpectInputError([&] { ReadTriangleSoup(file + "#c"); },
                   {file, "\"c\"", "allowed: a, b"});

  // A file under the whole name is taken as it is.
  std::filesystem::copy_file(file, dir + "/two.obj#b.obj");
  EXPECT_EQ(ReadTriangleSoup(dir + "/two.obj#b.obj").triangles.rows(), 5);
}

TEST(MeshPath, OnlySomeFormatsHaveParts) {
  const std::string dir = TestTempDir();
  for (const char* name : {"/a.ply", "/a.off", "/a.stl", "/a.vtk", "/a.obj"}) {
    WriteTriangleSoup(dir + name, UnitTetrahedron());
    ExpectInputError([&] { ReadTriangleSoup(dir + name + "#b"); },
                     {dir + name, "no part \"b\"", "leave out \"#b\""});
  }
}

TEST(MeshPath, AFileThatIsMissingIsNamedWithoutItsPart) {
  ExpectInputError([] { ReadTriangleSoup("no/a.obj#b"); },
                   {"no/a.obj: does not exist"});
}

}  // namespace
}  // namespace musclewarp
