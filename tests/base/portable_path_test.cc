// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/portable_path.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// A folder with data/bone one.ply and the empty folder run.
std::string FolderWithData() {
  const std::string dir = TestTempDir();
  fs::create_directories(dir + "/data");
  fs::create_directories(dir + "/run");
  WriteTextAtomically(dir + "/data/bone one.ply", "");
  return dir;
}

TEST(PortablePath, LeadsFromAFolder) {
  const std::string dir = FolderWithData();
  EXPECT_EQ(PathFrom(dir, dir + "/data/bone one.ply"), "data/bone one.ply");
  EXPECT_EQ(PathFrom(dir + "/run", dir + "/run/../data"), "../data");
  EXPECT_EQ(PathFrom(dir + "/run/", dir + "/run"), ".");
  // What is not there may be no path at all.
  EXPECT_EQ(PathFrom(dir, dir + "/none.ply"), dir + "/none.ply");
  EXPECT_EQ(PathFrom(dir, ""), "");
}

TEST(PortablePath, TextsMayNameAPartOfAFile) {
  const std::string dir = FolderWithData();
  EXPECT_EQ(
      WithPathsFrom(dir + "/run", dir + "/data/bone one.ply#a b: is open"),
      "../data/bone one.ply#a b: is open");
}

TEST(PortablePath, FromTheWorkingFolderLeadsFromTheOtherFolder) {
  const std::string dir = FolderWithData();
  const std::string given = fs::relative(dir + "/data").string();
  EXPECT_EQ(PathFrom(dir + "/run", given), "../data");
}

TEST(PortablePath, HoldsBehindALinkedFolder) {
  const std::string dir = FolderWithData();
  fs::create_directories(dir + "/store/deep/run");
  fs::create_directory_symlink(dir + "/store/deep/run", dir + "/linked");
  const std::string path = PathFrom(dir + "/linked", dir + "/data");
  EXPECT_TRUE(fs::equivalent(dir + "/linked/" + path, dir + "/data")) << path;
}

TEST(PortablePath, PathsInATextLeadFromAFolder) {
  const std::string dir = FolderWithData();
  EXPECT_EQ(WithPathsFrom(dir + "/run",
                          dir + "/data/bone one.ply: 3 mm/rad, see " + dir +
                              "/data, 1 / 2"),
            "../data/bone one.ply: 3 mm/rad, see ../data, 1 / 2");
  EXPECT_EQ(WithPathsFrom(dir + "/run",
                          "deform --scene='" + dir +
                              "/data/bone one.ply' --out=" + dir + "/run"),
            "deform --scene='../data/bone one.ply' --out=.");
  EXPECT_EQ(WithPathsFrom(dir, "in " + dir + "/data."), "in data.");
  const std::string given = fs::relative(dir + "/data").string();
  EXPECT_EQ(WithPathsFrom(dir + "/run", given + "/bone one.ply: is open"),
            "../data/bone one.ply: is open");
  EXPECT_EQ(WithPathsFrom(dir, "pose /none, https://here"),
            "pose /none, https://here");
}

TEST(PortablePath, WithoutFoldersOnlyTheLastPartIsLeft) {
  EXPECT_EQ(WithoutFolders("/home/anna/a.ply: 3 mm/rad, not (/x/b.obj)"),
            "a.ply: 3 mm/rad, not (b.obj)");
  EXPECT_EQ(WithoutFolders("--scene='/home/an na/s c.json' --data=../../d/"),
            "--scene='s c.json' --data=d");
  EXPECT_EQ(WithoutFolders("scene/bone.ply, rest/../m, 1 / 2"),
            "scene/bone.ply, rest/../m, 1 / 2");
}

}  // namespace
}  // namespace musclewarp
