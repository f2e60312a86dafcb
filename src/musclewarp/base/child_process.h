// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// How another program ended.
struct ChildResult {
  int exit_code = -1;      // -1 unless it ended by itself
  int signal = 0;          // that killed it, or 0
  bool timed_out = false;  // it was killed because it took too long
  std::string output;      // the end of what it printed, errors included

  bool IsFine() const { return exit_code == 0; }

  // Says in words how the program ended, with the last line it printed.
  std::string Text() const;
};

// Returns the path of a program: `name` itself if it has a slash and can be
// executed, else the first program of that name in the folders of PATH; empty
// if there is none.
std::string FindProgram(const std::string& name);

// Runs a program in the folder `dir` and waits for it, for at most `timeout_s`
// seconds, after which it is killed. The first argument is the path of the
// program. What it prints goes to a file in `dir`. Throws InputError that names
// the program if it cannot be started.
ChildResult RunChild(const std::vector<std::string>& arguments,
                     const std::string& dir,
                     double timeout_s);

}  // namespace musclewarp
