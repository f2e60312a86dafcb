// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/program/program_text.h"
#include "musclewarp/settings/thread_settings.h"

namespace musclewarp {

// The exit codes of all programs.
constexpr int kExitUsable = 0;     // done, and the result is usable
constexpr int kExitNotUsable = 1;  // ran, but the result is not usable
constexpr int kExitBadInput = 2;   // bad input or flags, nothing written

// The body of every program's main(). Parses the flags (gflags), runs `command`
// with the remaining arguments, and returns its exit code.
//
//   int main(int argc, char** argv) {
//     return musclewarp::RunProgram(argc, argv, kText, Command);
//   }
//
// The flags of the program have to be registered before (program/flags.h). For
// -h and --help, prints `text` and the flags that one needs, or all
// (program/help.h). An InputError is printed as "<program>:
// <message>", and the exit code is 2, as it is for unknown flags and values of
// the wrong type.
int RunProgram(
    int argc,
    char** argv,
    const ProgramText& text,
    const std::function<int(const std::vector<std::string>&)>& command);

// Sets the number of threads of OpenMP. Throws InputError, naming the setting,
// if it is not allowed.
void UseThreads(const ThreadSettings& settings);

// Throws InputError, naming the first argument, if there is any: for programs
// that take flags only.
void RefuseArguments(const std::vector<std::string>& arguments);

}  // namespace musclewarp
