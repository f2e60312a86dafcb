// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/input_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

TEST(ReadFile, ReturnsEveryByte) {
  std::string bytes = "line\r\nline\n";
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  const std::string path = TestTempDir() + "/bytes";
  std::ofstream(path, std::ios::binary) << bytes;
  EXPECT_EQ(ReadFile(path), bytes);
}

TEST(ReadFile, AMissingFileIsNamed) {
  const std::string path = TestTempDir() + "/none.ply";
  ExpectInputError([&] { ReadFile(path); }, {path, "does not exist"});
}

TEST(ReadFile, AFolderIsRefused) {
  const std::string path = TestTempDir();
  ExpectInputError([&] { ReadFile(path); }, {path, "is a folder"});
}

TEST(ReadFile, AnEmptyFileIsRefused) {
  const std::string path = TestTempDir() + "/empty";
  std::ofstream{path};
  ExpectInputError([&] { ReadFile(path); }, {path, "is empty"});
}

// Opening it would wait for a writer that never comes.
TEST(ReadFile, APipeIsRefused) {
  const std::string path = TestTempDir() + "/pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  ExpectInputError([&] { ReadFile(path); }, {path, "regular file"});
}

}  // namespace
}  // namespace musclewarp
