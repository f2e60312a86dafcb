// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/motion/solved_pose.h"
#include "musclewarp/report/frame_record.h"

namespace musclewarp {

// What a run keeps in DIR/.resume until it is finished, so that it can go on
// after an interruption: for every frame that is written its figures and where
// the next one starts, to the last bit.
class ResumeLog {
 public:
  ResumeLog(const std::string& dir, const std::string& inputs_hash);

  // The frames of an interrupted run of the same input, from the first of
  // `selected` on without a gap. `state` becomes that of the last of them, but
  // for its pose, if there is one. Throws InputError if DIR holds an
  // interrupted run of other input or options, or of a version of musclewarp
  // that keeps other files.
  std::vector<FrameRecord> Continue(const std::vector<int>& selected,
                                    SceneState* state) const;

  // Forgets an interrupted run.
  void StartAnew() const;

  // To call once the files of the frame are complete.
  void FrameDone(const FrameRecord& record, const SceneState& state) const;

  // The run is complete.
  void Finish() const;

 private:
  std::string FrameFile(int index) const;
  // The file that says of what version and input the log is, and its text.
  std::string KeyFile() const;
  std::string KeyText() const;

  std::string folder_;
  std::string inputs_hash_;
};

}  // namespace musclewarp
