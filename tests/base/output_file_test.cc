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

}  // namespace musclewarp
