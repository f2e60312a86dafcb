// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace musclewarp {

// A command that users can take as it is, but for its files.
struct CommandExample {
  std::string command;
  std::string what;  // what it does: "deforms ten frames"
};

// What a program says of itself, beside its flags. Help, man page and
// completion are made from it.
struct ProgramText {
  // The lines of synopsis, and after an empty line what the program does. Ends
  // with "Exit code: ...".
  std::string usage;

  std::vector<CommandExample> examples;

  // The names of the few flags that most users need. They stand first.
  std::vector<std::string> main_flags;
};

}  // namespace musclewarp
