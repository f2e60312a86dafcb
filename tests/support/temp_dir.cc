// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/temp_dir.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

namespace musclewarp {

std::string TestTempPath() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(::testing::TempDir()) /
         ("musclewarp_" + std::to_string(getpid())) /
         (std::string(test->test_suite_name()) + "." + test->name());
}

std::string TestTempDir() {
  const std::string dir = TestTempPath();
  std::filesystem::remove_all(dir);
  std::filesystem::create_directories(dir);
  return dir;
}

}  // namespace musclewarp
