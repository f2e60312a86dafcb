// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/opensim/model.h"
#include "musclewarp/run/lines_file.h"

namespace musclewarp {

// What a run measured, as its report has it.
struct MeasuredRun {
  std::string name;     // in messages: its folder
  std::string contact;  // the name of its contact mode
  bool is_of_design = false;
  std::vector<FrameFigures> frames;
  std::vector<MuscleLines> at_rest;  // lines and fibres; may be empty
};

// Reads report.json of one or more runs, of this or another version, and their
// lines at rest. `model` is set to that of the first run, or to that of
// `model_path` if that is not empty. Throws InputError that names the run and
// the field if a motion is not usable, if a run is not finished, or has no
// model or another one than the first.
std::vector<MeasuredRun> ReadMeasuredRuns(const std::vector<std::string>& dirs,
                                          const std::string& model_path,
                                          Model* model);

}  // namespace musclewarp
