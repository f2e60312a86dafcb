// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/temp_dir.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// The folder of this process.
fs::path Root() {
  return fs::path(::testing::TempDir()) /
         ("musclewarp_" + std::to_string(getpid()));
}

fs::path FolderOf(const ::testing::TestInfo& test) {
  return Root() / (std::string(test.test_suite_name()) + "." + test.name());
}

// Removes the folders of the tests that did not fail.
class Remover : public ::testing::EmptyTestEventListener {
 public:
  void OnTestEnd(const ::testing::TestInfo& test) override {
    std::error_code ignored;
    if (!test.result()->Failed()) fs::remove_all(FolderOf(test), ignored);
  }
  // Besides the folders there are the outputs of programs (RunCommandLine).
  void OnTestProgramEnd(const ::testing::UnitTest& tests) override {
    std::error_code ignored;
    if (!tests.Failed()) fs::remove_all(Root(), ignored);
  }
};

}  // namespace

std::string TestTempPath() {
  static const bool kIsListening = [] {
    ::testing::UnitTest::GetInstance()->listeners().Append(new Remover);
    return true;
  }();
  (void)kIsListening;
  fs::create_directories(Root());
  return FolderOf(*::testing::UnitTest::GetInstance()->current_test_info());
}

std::string TestTempDir() {
  const std::string dir = TestTempPath();
  fs::remove_all(dir);
  fs::create_directories(dir);
  return dir;
}

}  // namespace musclewarp
