// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/settings/thread_settings.h"

namespace musclewarp {

// The exit codes of all programs.
constexpr int kExitUsable = 0;     // done, and the result is usable
constexpr int kExitNotUsable = 1;  // ran, but the result is not usable
constexpr int kExitBadInput = 2;   // bad input or flags, nothing written

// The body of every program's main. It parses the flags (gflags) and runs
// `command` with the arguments that are no flags, whose exit code it returns.
//
//   int main(int argc, char** argv) {
//     return musclewarp::RunProgram(argc, argv, "my-program FILE...", Command);
//   }
//
// Its flags have to be registered before (program/flags.h). For --help it
// prints `usage` and these flags; `usage` is a line of synopsis and then what
// the program does. An InputError is printed as "<program>: <message>", and the
// exit code is 2, as it is for unknown flags and values of the wrong type.
int RunProgram(
    int argc,
    char** argv,
    const std::string& usage,
    const std::function<int(const std::vector<std::string>&)>& command);

// Has OpenMP use so many threads. Throws InputError, naming the setting, if the
// number is not allowed.
void UseThreads(const ThreadSettings& settings);

// For programs that take flags only: throws InputError, naming the first
// argument, if there is one.
void RefuseArguments(const std::vector<std::string>& arguments);

}  // namespace musclewarp
