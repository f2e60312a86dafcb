// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/motion/recorded_step.h"

namespace musclewarp {

// Writes the steps of a run to FOLDER/rest_step_01.step, ... for the separation
// of the rest pose, and FOLDER/frame_0003_step_01.step, ... for a frame; and
// the flags of the run to FOLDER/flags, for step_benchmark.
class StepRecorder {
 public:
  // Throws InputError if the folder cannot be made or written.
  StepRecorder(std::string folder, const std::string& flags);

  // Steps from here on are those of a frame; at first they are those of the
  // rest pose.
  void BeginFrame(int index);

  // Writes a step. The first one removes what the folder has of the same frame:
  // the rest pose may be separated again, with other meshes.
  void Write(int number, const RecordedStep& step) const;

 private:
  const std::string folder_;
  std::string frame_ = "rest";
};

}  // namespace musclewarp
