// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/output_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "musclewarp/base/input_error.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace fs = std::filesystem;

std::string TextOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(OutputFile, ReplacesTheOldContents) {
  const std::string path = TestTempDir() + "/a.txt";
  WriteTextAtomically(path, "old");
  WriteTextAtomically(path, "new");
  EXPECT_EQ(TextOf(path), "new");
}

TEST(OutputFile, AFailedWriteLeavesTheOldFileAndNothingElse) {
  const std::string dir = TestTempDir();
  WriteTextAtomically(dir + "/a.txt", "old");
  EXPECT_THROW(WriteFileAtomically(dir + "/a.txt",
                                   [](const std::string& partial) {
                                     std::ofstream(partial) << "half";
                                     throw std::runtime_error("disk full");
                                   }),
               std::runtime_error);
  EXPECT_EQ(TextOf(dir + "/a.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(dir), {}), 1);
}

TEST(OutputFile, AMissingFolderIsNamed) {
  const std::string path = TestTempDir() + "/nowhere/a.txt";
  try {
    WriteTextAtomically(path, "text");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr(path));
  }
}

TEST(OutputFolder, AppearsCompleteAndReplacesTheOldOne) {
  const std::string dir = TestTempDir() + "/frame";
  WriteFolderAtomically(dir, [](const std::string& partial) {
    WriteTextAtomically(partial + "/old.txt", "old");
  });
  WriteFolderAtomically(dir, [&](const std::string& partial) {
    EXPECT_TRUE(fs::exists(dir + "/old.txt"));
    WriteTextAtomically(partial + "/new.txt", "new");
  });
  EXPECT_FALSE(fs::exists(dir + "/old.txt"));
  EXPECT_EQ(TextOf(dir + "/new.txt"), "new");
}

TEST(OutputFolder, MayBeNamedWithASlashAtTheEnd) {
  const std::string dir = TestTempDir() + "/frame";
  for (const char* text : {"old", "new"}) {
    WriteFolderAtomically(dir + "/", [&](const std::string& partial) {
      WriteTextAtomically(partial + "/a.txt", text);
    });
    EXPECT_EQ(TextOf(dir + "/a.txt"), text);
  }
}

// As if another program had removed what was being written.
TEST(OutputFolder, AFolderThatCannotBeReplacedIsPutBack) {
  const std::string parent = TestTempDir();
  WriteFolderAtomically(parent + "/frame", [](const std::string& partial) {
    WriteTextAtomically(partial + "/old.txt", "old");
  });
  EXPECT_THROW(WriteFolderAtomically(
                   parent + "/frame",
                   [](const std::string& partial) { fs::remove_all(partial); }),
               InputError);
  EXPECT_EQ(TextOf(parent + "/frame/old.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(parent), {}), 1);
}

TEST(OutputFolder, AFailedWriteLeavesTheOldFolderAndNothingElse) {
  const std::string parent = TestTempDir();
  WriteFolderAtomically(parent + "/frame", [](const std::string& partial) {
    WriteTextAtomically(partial + "/old.txt", "old");
  });
  EXPECT_THROW(WriteFolderAtomically(parent + "/frame",
                                     [](const std::string& partial) {
                                       WriteTextAtomically(partial + "/a", "a");
                                       throw std::runtime_error("disk full");
                                     }),
               std::runtime_error);
  EXPECT_EQ(TextOf(parent + "/frame/old.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(parent), {}), 1);
}

TEST(OutputFolder, LeftoversOfKilledProgramsAreRemoved) {
  const std::string dir = TestTempDir();
  fs::create_directories(dir + "/.frame_0001.partial");
  WriteTextAtomically(dir + "/.frame_0001.partial/muscle.ply", "half");
  WriteTextAtomically(dir + "/.report.partial123.json", "half");
  WriteTextAtomically(dir + "/a.partial", "a user's");
  RemovePartialOutput(dir);
  EXPECT_EQ(std::distance(fs::directory_iterator(dir), {}), 1);
  EXPECT_TRUE(fs::exists(dir + "/a.partial"));
}

}  // namespace musclewarp
