// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/certified_contact/step_options.h"

namespace musclewarp {

// The inputs and the result of a step of certified contact. A recorded step can
// be repeated outside its run, to time its stages or to compare versions of the
// code.
struct RecordedStep {
  // As in PoseStep. Of its StepOptions, only the fields that vary from step to
  // step; the others are those of the run.
  ScenePose pose;
  bool is_settling = false;
  double max_push = 0;  // mm
  double reach = 0;     // mm
  int sweeps = 0;
  bool unfolds = false;
  std::vector<char> is_still;
  std::vector<double> reaches;  // mm

  ContactState before;
  ContactState after;  // without points if its push was too large

  // No vertices are attached before the rest pose is known.
  bool IsOfRestPose() const { return before.held.empty(); }

  // Returns the options of the step in a run with the options `of_run`.
  StepOptions OptionsIn(const StepOptions& of_run) const;
};

// Called after every attempted step. `number` counts from 1 within a frame, or
// within the relaxation of the rest pose.
using StepCallback = std::function<void(int number, const RecordedStep& step)>;

// Write a step to a file and read it back, bit for bit. Both throw InputError:
// if the file cannot be written, or is not an intact recorded step of this
// version.
void WriteRecordedStep(const std::string& path, const RecordedStep& step);
RecordedStep ReadRecordedStep(const std::string& path);

}  // namespace musclewarp
