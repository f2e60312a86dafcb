// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/run/frame_files.h"

namespace musclewarp {

// What musclewarp-deform is asked for; most fields are its flags.
struct DeformOptions {
  std::string scene;
  std::string data_root;  // empty: the folder of the scene
  std::string out;
  DeformerOptions deformer;
  std::string frames = "all";  // see SelectFrames
  FrameFileOptions files;
  ModelSources model;  // what is not as the scene has it
  int threads = 0;     // 0: as many as OpenMP chooses
  bool resume = false;
  bool overwrite = false;    // if true, frames of unknown runs are removed
  bool html = false;         // if true, report.html is written, too
  bool is_terminal = false;  // true if the screen is a terminal

  // The folder to which every step of certified contact is written
  // (StepRecorder), or empty, and the flags that are written with them.
  std::string record_steps;
  std::string step_flags;

  // For the record: the flags that make a difference to the result, the command
  // line that repeats the run, and all flags with their values.
  std::string result_flags;
  std::string command;
  std::map<std::string, std::string> all_flags;
};

// Throws InputError if no scene can be run with the options.
void CheckSceneOptions(const DeformOptions& options);

// Deforms the muscles of a scene in every selected pose, writes the frames and
// report.json to `out` and a summary to `screen`. In a motion each frame starts
// from the one before, and tables of lengths, volumes and moment arms are
// written as well. Whenever the program is killed, the files that are there are
// complete. With `resume` an interrupted run of the same input is continued
// where it was, to the same result. A run that is interrupted (SIGINT, SIGTERM)
// or cannot write a frame says why in its report. Returns an exit code. Throws
// InputError, before anything is written, for bad input.
int DeformCommand(const DeformOptions& options, std::ostream& screen);

}  // namespace musclewarp
