// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/certified_contact/step_options.h"

namespace musclewarp {

// A step of a scene in contact to a pose as it was taken, so that it can be
// taken again elsewhere: to time its stages, or to see what a change of the
// code makes of it.
struct RecordedStep {
  // As in PoseStep. Of its StepOptions only what differs from step to step; all
  // others are those of the run.
  ScenePose pose;
  bool is_settling = false;
  double max_push = 0;  // mm
  double reach = 0;     // mm
  int sweeps = 0;

  ContactState before;
  ContactState after;  // without points if the step was given up

  // Before the rest pose is known, nothing is attached.
  bool IsOfRestPose() const { return before.held.empty(); }

  // Returns the options of the step, in a run with the options `of_run`.
  StepOptions OptionsIn(const StepOptions& of_run) const;
};

// Called after every step that is tried. `number` counts from 1 in the steps of
// a frame, or in those that separate the rest pose.
using StepCallback = std::function<void(int number, const RecordedStep& step)>;

// Writes a step to a file and reads it back, to the last bit. Both throw
// InputError: if the file cannot be written, or is no recorded step of this
// version.
void WriteRecordedStep(const std::string& path, const RecordedStep& step);
RecordedStep ReadRecordedStep(const std::string& path);

}  // namespace musclewarp
