// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/deformer/deformer.h"

namespace musclewarp {

struct DeformOptions {
  std::string scene;
  std::string data_root;  // empty: the folder of the scene
  std::string out;
  DeformerOptions deformer;
  std::string frames = "all";  // see SelectFrames
  std::vector<std::string> formats = {"ply"};
  std::string motion;  // in place of the scene's
  int threads = 0;     // 0: as many as OpenMP chooses
  bool resume = false;
  bool html = false;         // also report.html
  bool is_terminal = false;  // `screen` is one
  // The flags that make a difference to the result, and the command line that
  // runs it again; for the record.
  std::string result_flags;
  std::string command;
  std::map<std::string, std::string> all_flags;  // defaults too
};

// Names of flags to values; InputError names the flag and what is allowed.
SolverConfiguration ParseSolver(const std::string& text);
ContactKind ParseContact(const std::string& text);
ContactLevel ParseContactLevel(const std::string& text);
std::vector<std::string> ParseFormats(const std::string& text);

// Throw InputError: options that no scene can be run with, a folder that cannot
// be written (it is not made), one that cannot be made.
void CheckSceneOptions(const DeformOptions& options);
void CheckWritable(const std::string& dir);
void MakeFolder(const std::string& dir);

// Deforms the muscles of a scene in every selected pose, writes the frames and
// report.json to `out` and a summary to `screen`; of a motion each frame starts
// from the one before, and tables of lengths, volumes and moment arms are
// written as well. Whenever it is killed, what is there is complete. With
// `resume` an interrupted run of the same input goes on where it was, to the
// same result. A run that is interrupted (SIGINT, SIGTERM) or cannot write a
// frame says why in its report. Returns an exit code. Throws InputError, before
// anything is written, for bad input.
int DeformCommand(const DeformOptions& options, std::ostream& screen);

}  // namespace musclewarp
