// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "tools/run_program.h"

namespace musclewarp {

// Runs musclewarp-deform without contact, unless `arguments` say otherwise.
ProgramRun Deform(const std::string& arguments);

// A scene of one spindle and one bone in the folder of the test; the spindle
// bends into the bone in the second of two poses. Tests change the scene before
// they run it.
class DeformProgram : public ::testing::Test {
 protected:
  DeformProgram();

  // Runs musclewarp-deform on the scene as it is now.
  ProgramRun Run(const std::string& flags = "");

  // Runs it and expects exit code 2, all words in the message, and nothing
  // written.
  void ExpectRefused(const std::vector<std::string>& words,
                     const std::string& flags = "");

  void WriteMuscle(const TriangleSoup& soup);

  std::string out() const { return dir_ + "/out"; }

  const std::string dir_;
  nlohmann::json scene_;
};

}  // namespace musclewarp
