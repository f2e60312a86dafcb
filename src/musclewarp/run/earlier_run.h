// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace musclewarp {

// What report.json in the folder of a run says of that run.
struct EarlierRun {
  std::string inputs_hash;
  std::string code_key;  // of the code that computed it (build_info.h)
  bool is_finished = false;
  bool is_usable = false;
  std::vector<std::string> frames;  // the folders of its frames
};

// Returns what DIR/report.json says, or nothing if there is no such file.
// Throws InputError if it is there but is no report of a run.
std::optional<EarlierRun> ReadEarlierRun(const std::string& dir);

// Throws InputError if `dir` has folders of frames that belong to no run that
// RemoveEarlierRun() would know: neither report.json names them, nor was a run
// interrupted here. Nothing is thrown if `overwrite` is true.
void CheckNoStrangeFrames(const std::string& dir, bool overwrite);

// Removes what an earlier run has left in `dir`, so that nothing of it is taken
// for part of the next: all folders of frames, the rest pose, tables, pages and
// the report, which goes last. Other files stay, and so do tables and pages
// where there is no report. Returns the number of frames removed. Call
// CheckNoStrangeFrames() first.
int RemoveEarlierRun(const std::string& dir);

}  // namespace musclewarp
