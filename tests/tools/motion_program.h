// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/opensim/storage_table.h"
#include "tools/run_program.h"

namespace musclewarp {

// A scene with an OpenSim model and a motion in the folder of the test: a
// spindle along y over a knee at (0, -400, 0) mm that turns about z, between
// two balls of bone; the knee bends by 30 degrees in 7 rows. Tests change the
// texts of the model, the motion and the scene before they run it.
class MotionProgram : public ::testing::Test {
 protected:
  MotionProgram();

  // Writes the texts as they are now, and returns the arguments that make
  // musclewarp-deform run them into the folder `out`, without contact unless
  // `flags` say otherwise.
  std::string Arguments(const std::string& flags, const std::string& out);

  ProgramRun Run(const std::string& flags = "");

  // Runs it and expects exit code 2, all words in the message, and nothing
  // written.
  void ExpectRefused(const std::vector<std::string>& words);

  // The same with the first `from` in `text`, which is one of the texts below,
  // replaced for one run.
  void ExpectRefusedWith(std::string* text,
                         const std::string& from,
                         const std::string& to,
                         const std::vector<std::string>& words);

  std::string out() const { return dir_ + "/out"; }
  nlohmann::json Report() const;
  StorageTable Table(const std::string& name) const;

  const std::string dir_;
  std::string model_, motion_;
  nlohmann::json scene_;
};

}  // namespace musclewarp
