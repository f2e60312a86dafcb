// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace musclewarp {

// Runs programs on the public data sets below MUSCLEWARP_DATA_ROOT; skips
// without it.
class ProgramsDataTest : public ::testing::Test {
 protected:
  void SetUp() override;

  // Runs a scene file with default options unless `flags` say otherwise,
  // expects exit code 0 and returns the report.
  nlohmann::json DeformFile(const std::string& scene_file,
                            const std::string& out,
                            const std::string& flags = "");

  // The same for a scene of data/scenes, with a solver and without contact
  // unless `flags` say otherwise.
  nlohmann::json Deform(const std::string& scene,
                        const std::string& solver,
                        const std::string& out,
                        const std::string& flags = "");

  std::string root_;
};

}  // namespace musclewarp
