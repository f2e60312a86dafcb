// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

struct ProgramRun {
  int exit_code = -1;
  std::string out;     // standard output
  std::string errors;  // standard error
};

// Runs a program with arguments for the shell.
ProgramRun RunCommandLine(const std::string& program,
                          const std::string& arguments);

std::string FileText(const std::string& path);

}  // namespace musclewarp
