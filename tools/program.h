// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace musclewarp {

// Exit codes of all programs.
constexpr int kExitUsable = 0;     // done, and the result is usable
constexpr int kExitNotUsable = 1;  // ran, but the result is not usable
constexpr int kExitBadInput = 2;   // bad input or flags, nothing written

// The main of every program: parses the flags (gflags), prints a help text of
// the program's own flags for --help, and runs `command` with the remaining
// arguments. An InputError is printed as "<program>: <message>", exit code 2;
// so are unknown flags and values of the wrong type. `usage` is the help text
// above the flags: a line of synopsis, then what the program does.
int RunProgram(
    int argc,
    char** argv,
    const std::string& usage,
    const std::function<int(const std::vector<std::string>&)>& command);

// For programs that take flags only: throws InputError if there is an argument.
void RefuseArguments(const std::vector<std::string>& arguments);

}  // namespace musclewarp
