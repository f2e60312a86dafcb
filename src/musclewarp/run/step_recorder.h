// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/motion/recorded_step.h"

namespace musclewarp {

// Writes the steps of a run for step_benchmark: to FOLDER/rest_step_01.step and
// so on for the separation of the rest pose, and to
// FOLDER/frame_0003_step_01.step and so on for a frame. The flags of the run go
// to FOLDER/flags.
class StepRecorder {
 public:
  // Makes the folder and writes the flags. Throws InputError if that fails.
  StepRecorder(std::string folder, const std::string& flags);

  // Assigns the following steps to a frame. Before the first call, steps are
  // those of the rest pose.
  void BeginFrame(int index);

  // Writes a step. The first step of a frame removes the earlier files of this
  // frame, because the rest pose may be separated again with other meshes.
  void Write(int number, const RecordedStep& step) const;

 private:
  const std::string folder_;
  std::string frame_ = "rest";
};

}  // namespace musclewarp
